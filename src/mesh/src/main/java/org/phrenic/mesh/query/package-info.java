/** Questions to a mesh: nearest point, distance, rays, sections, geodesics. */
package org.phrenic.mesh.query;
