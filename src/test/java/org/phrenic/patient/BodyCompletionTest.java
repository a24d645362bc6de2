package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.Thorax;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.anatomy.virtual.VirtualThoraxParametersReader;
import org.phrenic.geometry.DistanceSummary;
import org.phrenic.geometry.MeshQuality;
import org.phrenic.geometry.MeshTopology;
import org.phrenic.geometry.SurfaceComparison;
import org.phrenic.geometry.TriangleMesh;

/** The virtual adult female is the patient: of her a scan shows the lungs alone, and the rest is made of the male. */
class BodyCompletionTest {
    private static Thorax thorax(String preset) {
        return VirtualThorax.generate(VirtualThoraxParametersReader.preset(preset), Resolution.LOW);
    }

    private static FittedBody scanOf(Thorax patient, String cutAt) {
        List<Organ> organs = new ArrayList<>();
        for (Structure lung : patient.all(StructureKind.LUNG)) {
            MeshedPart meshed =
                    new MeshedPart(lung.mesh(), 0, 0, DistanceSummary.NONE, MeshQuality.of(lung.mesh()), 0.2, 1, 0);
            organs.add(Organ.ofScan(lung, new Organ.Scan(List.of(1), 1000, 1000, cutAt, meshed)));
        }
        return new FittedBody("patient", organs, ThoraxList.missing(organs), List.of());
    }

    @Test
    void ofTheLungsAloneABodyIsMadeWhoseDiaphragmLiesNearThePatients() {
        Thorax patient = thorax("adult-female");
        Thorax template = thorax("adult-male");
        FittedBody body = BodyCompletion.complete(scanOf(patient, ""), template);
        assertThat(body.canBreathe()).isTrue();
        assertThat(body.missing()).isEmpty();
        assertThat(body.organs()).hasSameSizeAs(template.structures());
        for (Organ organ : body.organs()) {
            boolean lung = organ.structure().kind() == StructureKind.LUNG;
            assertThat(organ.source()).isEqualTo(lung ? Organ.Source.SCAN : Organ.Source.VIRTUAL);
            if (lung) {
                assertThat(organ.offScan().orElseThrow().mean()).isLessThan(3);
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
        return thorax.all(StructureKind.DIAPHRAGM).get(0).mesh();
    }

    @Test
    void withoutAWholeLungNothingIsInvented() {
        FittedBody slab = scanOf(thorax("adult-female"), "S");
        FittedBody body = BodyCompletion.complete(slab, thorax("adult-male"));
        assertThat(body.organs()).isEqualTo(slab.organs());
        assertThat(body.missing()).contains("diaphragm");
        assertThat(body.notes()).singleElement().asString().contains("no whole lung");
    }
}
