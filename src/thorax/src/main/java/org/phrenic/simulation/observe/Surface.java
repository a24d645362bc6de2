package org.phrenic.simulation.observe;

import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;

/**
 * One surface of a running scene.
 *
 * @param name of the structure, such as {@code rib_05_R}
 * @param kind what it is
 * @param level rib, cartilage or vertebra number; 0 where it means nothing
 * @param side side of the body
 * @param rest as it is at end-expiration, LPS, mm; triangles never change
 * @param motion how a {@link Frame} gives its place
 * @param tendon for each vertex whether it is central tendon; empty but for the diaphragm
 */
public record Surface(
        String name, StructureKind kind, int level, Side side, TriangleMesh rest, Motion motion, boolean[] tendon) {
    /** How a surface moves. */
    public enum Motion {
        /** It never moves. */
        STILL,
        /** As one rigid body: a frame gives its pose. */
        RIGID,
        /** Vertex by vertex: a frame gives all positions. */
        DEFORMING
    }
}
