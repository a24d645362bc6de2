/** Triangle meshes: topology, measures, quality. What any reader or editor of meshes shares. */
package org.phrenic.mesh;
