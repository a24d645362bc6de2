/** A thorax: named structures, the diaphragm's parts, folders of meshes, resolutions. */
package org.phrenic.anatomy;
