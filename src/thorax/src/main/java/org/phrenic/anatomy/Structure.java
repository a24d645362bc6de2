package org.phrenic.anatomy;

import org.phrenic.mesh.TriangleMesh;

/**
 * One named surface of a thorax.
 *
 * @param name the name of its file without ending, such as {@code rib_05_R}, {@code costal_cartilage_02_L},
 *     {@code sternum_body}, {@code vertebra_T06}, {@code lung_R}, {@code diaphragm}
 * @param kind what it is
 * @param level rib or cartilage number 1-12; vertebra as T1 = 1 ... T12 = 12, L1 = 13 ... L5 = 17; 0 where it means
 *     nothing
 * @param side side of the body
 * @param mesh surface, LPS, mm
 */
public record Structure(String name, StructureKind kind, int level, Side side, TriangleMesh mesh) {

    /** The same structure with another surface. */
    public Structure withMesh(TriangleMesh other) {
        return new Structure(name, kind, level, side, other);
    }
}
