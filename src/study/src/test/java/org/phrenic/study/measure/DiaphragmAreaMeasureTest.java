package org.phrenic.study.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.DomeSheet;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Areas of the sheets of the virtual bodies at rest, and of a dome that goes down. */
class DiaphragmAreaMeasureTest {
    /** The tendon has its share of both faces together, and of one about as much. */
    private static final double OF_ONE_FACE = 0.5;

    private static final double DOWN_MM = 10;

    private static SceneGeometry view(TriangleMesh mesh, Surface.Motion motion) {
        Diaphragm sheet = Diaphragm.withTrefoilTendon(mesh);
        boolean[] tendon = new boolean[mesh.vertexCount()];
        for (int i = 0; i < tendon.length; i++) {
            tendon[i] = sheet.isTendon(i);
        }
        Surface surface = new Surface("diaphragm", StructureKind.DIAPHRAGM, 0, Side.MIDLINE, mesh, motion, tendon);
        return new SceneGeometry(List.of(surface), sheet);
    }

    /** A dome that goes straight down by a centimetre sweeps that much below its outer face, which keeps its area. */
    @Test
    void aDomeThatGoesDownSweepsItsShadowTimesItsWay() {
        TriangleMesh dome = DomeSheet.adult(10);
        SceneGeometry view = view(dome, Surface.Motion.DEFORMING);
        double[] rest = dome.positions();
        Frame lower = new Frame(new Object(), new int[] {rest.length}, new boolean[1], 0);
        for (int i = 0; i < rest.length; i++) {
            lower.positions(0)[i] = (float) (i % 3 == 2 ? rest[i] - DOWN_MM : rest[i]);
        }
        view.update(lower);
        boolean[] thoracic = view.thoracicTriangles();
        int outer = dome.vertexCount() / 2;
        double[] cross = new double[3];
        double areaMm2 = 0;
        double shadowMm2 = 0;
        for (int t = 0; t < thoracic.length; t++) {
            int[] corners = Arrays.copyOfRange(dome.triangles(), 3 * t, 3 * t + 3);
            if (Arrays.stream(corners).allMatch(v -> v < outer)) {
                assertThat(thoracic[t]).as("outer face").isTrue();
            }
            if (thoracic[t]) {
                areaMm2 += 0.5 * MeshMeasure.triangleCrossProduct(dome, t, cross);
                shadowMm2 += 0.5 * cross[2];
            }
        }
        Map<String, Double> values = new LinkedHashMap<>();
        new DiaphragmAreaMeasure(view).measure(view, lower, values);
        // The ellipse of the rim, 130 by 90 mm, with corners, but for half of what joins the faces there.
        assertThat(shadowMm2).isCloseTo(Math.PI * 130 * 90, withinPercentage(4));
        assertThat(values.get("diaphragm_area_cm2")).isCloseTo(areaMm2 / 100, within(1e-3));
        assertThat(values.get("diaphragm_swept_ml")).isCloseTo(DOWN_MM * shadowMm2 / 1000, within(1e-2));
    }

    @ParameterizedTest
    @CsvSource({
        "adult-male, LOW", "adult-male, MEDIUM",
        "adult-female, LOW", "adult-female, MEDIUM",
        "high-colon-male, LOW", "high-colon-male, MEDIUM"
    })
    void theTendonHasTheShareThatItIsMadeWithHoweverFineTheSheetIs(String body, Resolution resolution) {
        TriangleMesh mesh = VirtualThorax.ofPreset(body, resolution)
                .find("diaphragm")
                .orElseThrow()
                .mesh();
        SceneGeometry view = view(mesh, Surface.Motion.STILL);
        view.update(null);
        Map<String, Double> values = new LinkedHashMap<>();
        new DiaphragmAreaMeasure(view).measure(view, null, values);
        assertThat(values).containsOnlyKeys(DiaphragmAreaMeasure.NAMES);
        double share = values.get("tendon_share_percent");
        assertThat(share).isCloseTo(100 * Diaphragm.TENDON_SHARE, within(OF_ONE_FACE));
        assertThat(values.get("tendon_area_cm2"))
                .isCloseTo(share / 100 * values.get("diaphragm_area_cm2"), within(1e-9));
        assertThat(values.get("diaphragm_swept_ml")).isZero();
    }
}
