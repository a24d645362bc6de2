package org.phrenic.patient.diaphragm;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.MedianFrame;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.file.Numbers;
import org.phrenic.mesh.TriangleMesh;

/** Unknown structures that pass through the diaphragm, as a tube does, or lie on both sides of it. */
public final class UnknownSides {
    /** Least share of the vertices of a structure on each side. */
    private static final double LEAST_SHARE = 0.1;

    private UnknownSides() {}

    /** One sentence that names them; empty if there are none, or no diaphragm. */
    public static Optional<String> note(Thorax scanned) {
        List<Structure> unknown = scanned.structuresOf(StructureKind.OTHER);
        List<Structure> sheets = scanned.structuresOf(StructureKind.DIAPHRAGM);
        if (unknown.isEmpty() || sheets.isEmpty() || sheets.get(0).mesh().triangleCount() == 0) {
            return Optional.empty();
        }
        MedianFrame frame = MedianFrame.of(scanned);
        TriangleMesh shells = frame.toFrame(sheets.get(0).mesh());
        Diaphragm diaphragm =
                Diaphragm.withTrefoilTendon(Diaphragm.sheetAmong(shells).orElse(shells));
        OrganSides below = new OrganSides(diaphragm, true, List.of());
        OrganSides above = new OrganSides(diaphragm, false, List.of());
        List<String> names = unknown.stream()
                .filter(s -> s.mesh().vertexCount() > 0)
                .flatMap(s -> onBothSides(frame.toFrame(s), below, above).stream())
                .toList();
        return names.isEmpty()
                ? Optional.empty()
                : Optional.of("unknown structures pass through or lie on both sides of the diaphragm, as tubes do or as"
                        + " the scan and not the body lies: " + String.join(", ", names));
    }

    /**
     * @param below what lies below counts, as of an organ of the chest
     * @param above what lies above counts, as of one of the abdomen
     */
    private static Optional<String> onBothSides(Structure s, OrganSides below, OrganSides above) {
        double share = below.share(s.mesh());
        return share < LEAST_SHARE || above.share(s.mesh()) < LEAST_SHARE
                ? Optional.empty()
                : Optional.of(Numbers.format("%s (%.0f %% below)", s.name(), 100 * share));
    }
}
