package org.phrenic.patient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.Structure;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshTopology;
import org.phrenic.mesh.Shapes;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.query.SurfaceComparison;
import org.phrenic.patient.registration.DiaphragmaticSurface;

/** A lung that an oblique fissure divides into two lobes, which are open there and lie 3 mm apart. */
class LungOutlineTest {
    private static final Structure LUNG = VirtualThorax.ofPreset("adult-female", Resolution.LOW)
            .find(StructureKind.LUNG, 0, Side.RIGHT)
            .orElseThrow();

    private static Structure lobe(boolean upper) {
        TriangleMesh lung = LUNG.mesh();
        double[] centre = lung.centre();
        IntList triangles = new IntList();
        for (int i = 0; i < lung.triangles().length; i += 3) {
            double above = 0;
            for (int k = 0; k < 3; k++) {
                int v = lung.triangles()[i + k];
                above += lung.z(v) - centre[2] - 0.8 * (lung.y(v) - centre[1]);
            }
            if (above > 0 == upper) {
                triangles.add(lung.triangles()[i]);
                triangles.add(lung.triangles()[i + 1]);
                triangles.add(lung.triangles()[i + 2]);
            }
        }
        double[] p = lung.positions().clone();
        for (int i = 2; i < p.length && upper; i += 3) {
            p[i] += 3;
        }
        return LUNG.withMesh(new TriangleMesh(p, triangles.toArray()));
    }

    @Test
    void theOutlineOfLobesIsTheSurfaceOfTheLung() {
        TriangleMesh outline =
                LungOutline.of(Stream.of(lobe(true), lobe(false))).orElseThrow();
        MeshTopology topology = new MeshTopology(outline);
        assertThat(topology.isClosed() && topology.isManifold()).isTrue();
        assertThat(topology.eulerCharacteristic()).isEqualTo(2);
        DistanceSummary off = SurfaceComparison.of(outline, LUNG.mesh()).byArea();
        assertThat(off.mean()).isLessThan(1.8);
        assertThat(off.percentile95()).isLessThan(4);
        // The gap of 3 mm is a part of the outline.
        double volume = MeshMeasure.signedVolume(LUNG.mesh());
        assertThat(MeshMeasure.signedVolume(outline)).isBetween(volume, 1.07 * volume);
        double base = MeshMeasure.area(DiaphragmaticSurface.of(LUNG.mesh()));
        assertThat(MeshMeasure.area(DiaphragmaticSurface.of(outline))).isCloseTo(base, within(0.1 * base));
    }

    /** Fluid in the fissure keeps the lobes 40 mm apart: the base is that of the lower lobe, be it the smaller one. */
    @Test
    void lobesFarApartAreBothInTheOutline() {
        Structure upper = LUNG.withMesh(Shapes.moved(Shapes.sphere(50, 4), -80, 0, 1100));
        Structure lower = LUNG.withMesh(Shapes.moved(Shapes.sphere(35, 4), -80, 0, 1100 - 50 - 35 - 40));
        TriangleMesh outline = LungOutline.of(Stream.of(upper, lower)).orElseThrow();
        assertThat(new MeshTopology(outline).eulerCharacteristic())
                .as("two spheres")
                .isEqualTo(4);
        double volume = MeshMeasure.signedVolume(upper.mesh()) + MeshMeasure.signedVolume(lower.mesh());
        assertThat(MeshMeasure.signedVolume(outline)).isCloseTo(volume, within(0.05 * volume));
        assertThat(outline.bounds()[2]).isCloseTo(lower.mesh().bounds()[2], within(2.0));
    }

    @Test
    void aLungOfOnePartIsItsOwnOutline() {
        assertThat(LungOutline.of(Stream.of(LUNG)).orElseThrow()).isSameAs(LUNG.mesh());
        assertThat(LungOutline.of(Stream.of())).isEmpty();
    }
}
