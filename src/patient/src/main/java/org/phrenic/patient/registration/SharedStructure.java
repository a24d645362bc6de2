package org.phrenic.patient.registration;

import java.util.List;
import java.util.Optional;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.patient.PatientStructure;

/**
 * A structure that scan and template have.
 *
 * @param organ the structure of the scan; of several parts all
 * @param template surface of the template at its original place, mm
 */
record SharedStructure(PatientStructure organ, TriangleMesh template) {
    /** Last rib of which the cartilage joins the body of the sternum above its lower end. */
    private static final int LAST_AT_BODY = 5;

    /** Surface in the scan, mm. */
    TriangleMesh scan() {
        return organ.structure().mesh();
    }

    boolean isComplete() {
        return organ.isComplete();
    }

    /**
     * Share of the structure that the scan shows: 1 if it shows all of it, else by volume.
     *
     * @param whole the template's, at its original place or placed on the scan
     */
    double shownShare(TriangleMesh whole) {
        return isComplete() ? 1 : MeshMeasure.signedVolume(scan()) / MeshMeasure.signedVolume(whole);
    }

    StructureKind kind() {
        return organ.structure().kind();
    }

    Side side() {
        return organ.structure().side();
    }

    int level() {
        return organ.structure().level();
    }

    String cutAt() {
        return organ.scan().map(PatientStructure.Scan::cutAt).orElse("");
    }

    /**
     * Both surfaces as a whole, with their nearest points.
     *
     * @param guidesBones as for {@link SurfacePair}
     */
    SurfacePair pair(boolean guidesBones) {
        return new SurfacePair(organ, scan(), template, guidesBones);
    }

    /** The structure of the scan moved along the body to the height at which the template's is placed. */
    SharedStructure atHeightOf(TemplateMap placed) {
        double[] p = scan().positions().clone();
        double dz = placed.apply(template).centre()[2] - scan().centre()[2];
        for (int z = 2; z < p.length; z += 3) {
            p[z] += dz;
        }
        return new SharedStructure(organ.withStructure(organ.structure().withMesh(scan().withPositions(p))), template);
    }

    /**
     * The upper end of the scan, if it shows costal cartilages below it and the sternum must lie above it: where the
     * fifth or a higher one is shown whole, the sternum lies in the scan and has no label.
     */
    static Optional<CutPlane> belowSternum(List<SharedStructure> shared) {
        boolean cartilages = shared.stream().anyMatch(s -> s.kind() == StructureKind.COSTAL_CARTILAGE);
        boolean inScan = shared.stream()
                .anyMatch(s -> s.kind() == StructureKind.STERNUM
                        || (s.kind() == StructureKind.COSTAL_CARTILAGE
                                && s.level() <= LAST_AT_BODY
                                && !s.cutAt().contains("S")));
        return shared.stream()
                .filter(s -> cartilages && !inScan)
                .flatMap(s -> s.organ().cuts().stream())
                .filter(cut -> cut.side().equals("S"))
                .findFirst();
    }
}
