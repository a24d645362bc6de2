package org.phrenic.study.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.anatomy.Diaphragm;
import org.phrenic.anatomy.Resolution;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.virtual.VirtualThorax;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.simulation.observe.Surface;

/** Areas of the sheets of the virtual bodies at rest. */
class DiaphragmAreaMeasureTest {
    /** The tendon has its share of both faces together, and of one about as much. */
    private static final double OF_ONE_FACE = 0.5;

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
        Diaphragm sheet = Diaphragm.withTrefoilTendon(mesh);
        boolean[] tendon = new boolean[mesh.vertexCount()];
        for (int i = 0; i < tendon.length; i++) {
            tendon[i] = sheet.isTendon(i);
        }
        Surface surface =
                new Surface("diaphragm", StructureKind.DIAPHRAGM, 0, Side.MIDLINE, mesh, Surface.Motion.STILL, tendon);
        SceneGeometry view = new SceneGeometry(List.of(surface), sheet);
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
