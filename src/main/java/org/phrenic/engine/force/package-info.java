/**
 * Force fields: springs, fibre muscle, action lines, pressure on faces, attachments to moving anchors, constant loads. Each is built over a {@link
 * org.phrenic.engine.NodeLayout} from the caller's node numbers, adds its forces block by block, and costs nothing while it is switched off.
 */
package org.phrenic.engine.force;
