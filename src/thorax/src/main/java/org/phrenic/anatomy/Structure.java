package org.phrenic.anatomy;

import org.phrenic.mesh.TriangleMesh;

/**
 * One named surface of a thorax.
 *
 * @param name file name without extension, such as {@code rib_05_R}, {@code costal_cartilage_02_L},
 *     {@code sternum_body}, {@code vertebra_T06}, {@code lung_R}, {@code diaphragm}
 * @param kind kind of structure
 * @param level number of a rib or cartilage, 1-12; vertebrae T1 = 1 ... T12 = 12, L1 = 13 ... L5 = 17; otherwise 0
 * @param side side of the body
 * @param mesh surface, LPS, mm
 */
public record Structure(String name, StructureKind kind, int level, Side side, TriangleMesh mesh) {

    /** Whether another one has the same kind, level and side, and the same name if there may be many of the kind. */
    public boolean isSameAs(Structure other) {
        return kind == other.kind
                && level == other.level
                && side == other.side
                && (!kind.isNamed() || name.equals(other.name));
    }

    /** Returns a copy with another surface. */
    public Structure withMesh(TriangleMesh other) {
        return new Structure(name, kind, level, side, other);
    }
}
