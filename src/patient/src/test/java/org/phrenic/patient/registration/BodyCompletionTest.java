package org.phrenic.patient.registration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParameters;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.patient.ExpectedStructures;
import org.phrenic.patient.MeshedSegment;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;

/** The virtual adult female is the patient: of her a scan shows the lungs alone, and the rest is made of the male. */
class BodyCompletionTest {
    private static Thorax thorax(String preset) {
        return VirtualThorax.generate(VirtualThoraxParameters.preset(preset), Resolution.LOW);
    }

    private static PatientBody scanOf(Thorax patient, String cutAt) {
        List<PatientStructure> organs = new ArrayList<>();
        for (Structure lung : patient.structuresOf(StructureKind.LUNG)) {
            MeshedSegment meshed =
                    new MeshedSegment(lung.mesh(), 0, 0, DistanceSummary.NONE, MeshQuality.of(lung.mesh()), 0.2, 1, 0);
            organs.add(PatientStructure.ofScan(lung, new PatientStructure.Scan(List.of(1), 1000, 1000, cutAt, meshed)));
        }
        return new PatientBody("patient", organs, ExpectedStructures.missing(organs), List.of());
    }

    @Test
    void ofTheLungsAloneABodyIsMadeWhoseDiaphragmLiesNearThePatients() {
        Thorax patient = thorax("adult-female");
        Thorax template = thorax("adult-male");
        PatientBody body = BodyCompletion.complete(scanOf(patient, ""), template);
        assertThat(body.canBreathe()).isTrue();
        assertThat(body.missing()).isEmpty();
        assertThat(body.structures()).hasSameSizeAs(template.structures());
        for (PatientStructure organ : body.structures()) {
            boolean lung = organ.structure().kind() == StructureKind.LUNG;
            assertThat(organ.source()).isEqualTo(lung ? PatientStructure.Source.SCAN : PatientStructure.Source.VIRTUAL);
            if (lung) {
                assertThat(organ.distanceToScan().orElseThrow().mean()).isLessThan(3);
            }
        }
        TriangleMesh built = diaphragm(body.thorax());
        MeshTopology topology = new MeshTopology(built);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        double off = SurfaceComparison.of(built, diaphragm(patient)).byArea().mean();
        double before = SurfaceComparison.of(diaphragm(template), diaphragm(patient))
                .byArea()
                .mean();
        assertThat(off).as("from %.1f mm as the template lies", before).isLessThan(0.5 * before);
    }

    private static TriangleMesh diaphragm(Thorax thorax) {
        return thorax.structuresOf(StructureKind.DIAPHRAGM).get(0).mesh();
    }

    @Test
    void withoutAWholeLungNothingIsInvented() {
        PatientBody slab = scanOf(thorax("adult-female"), "S");
        PatientBody body = BodyCompletion.complete(slab, thorax("adult-male"));
        assertThat(body.structures()).isEqualTo(slab.structures());
        assertThat(body.missing()).contains("diaphragm");
        assertThat(body.notes()).singleElement().asString().contains("no whole lung");
    }
}
