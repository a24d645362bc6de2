package org.phrenic.simulation.observe;

import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.BoundingBoxes;
import org.phrenic.mesh.TriangleMesh;

/**
 * A surface of a running scene.
 *
 * @param name of the structure, such as {@code rib_05_R}
 * @param kind of structure
 * @param level rib, cartilage or vertebra number; 0 if not applicable
 * @param side of the body
 * @param rest mesh at end-expiration, LPS, mm; its triangles never change
 * @param motion how a {@link Frame} stores its position
 * @param tendon whether each vertex belongs to the central tendon; empty except for the diaphragm
 */
public record Surface(
        String name, StructureKind kind, int level, Side side, TriangleMesh rest, Motion motion, boolean[] tendon) {
    /** Type of motion. */
    public enum Motion {
        /** No motion. */
        STILL,
        /** Rigid motion: a frame holds the pose. */
        RIGID,
        /** Deformation: a frame holds all vertex positions. */
        DEFORMING
    }

    /** {@code {minX, minY, minZ, maxX, maxY, maxZ}} at rest, mm; without surfaces, infinite with min above max. */
    public static double[] bounds(List<Surface> surfaces) {
        return BoundingBoxes.of(surfaces.stream().map(Surface::rest));
    }
}
