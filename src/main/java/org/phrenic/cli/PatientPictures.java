package org.phrenic.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import org.phrenic.anatomy.Meshes;
import org.phrenic.geometry.DistanceSummary;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.scene.FieldPicture;
import org.phrenic.scene.FigurePicture;
import org.phrenic.scene.LayersPicture;
import org.phrenic.scene.LayersPicture.Layer;
import org.phrenic.scene.Look;
import org.phrenic.scene.NoGraphicsException;
import org.phrenic.scene.Shot;
import org.phrenic.scene.View;
import org.phrenic.study.fit.FitDistances;
import org.phrenic.study.fit.FitResult;
import org.phrenic.study.paper.PatientCase;

/** Figures 4 and 5 of the paper for a patient of ours. */
final class PatientPictures {
    private static final int LUNG = 0xd98f86;
    private static final int INSPIRED = 0x2f74b5;
    private static final int SHEET = 0xb9483c;
    private static final int EDGES = 0x27303a;
    private static final float CLEAR = 0.3f;
    private static final float CLEARER = 0.16f;

    private final PatientCase patient;
    private final int size;
    private final String file;

    PatientPictures(PatientCase patient, int size) {
        this.patient = patient;
        this.size = size;
        file = patient.name().toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    }

    /** Lungs at both breath levels, and the diaphragm's mesh below them. */
    List<FigurePicture> segmented() throws NoGraphicsException {
        TriangleMesh expired = lungs(FitResult.TargetResult::initial);
        TriangleMesh inspired = Meshes.merge(
                patient.lungs().stream().map(t -> t.target().surface()).toList());
        List<Layer> levels =
                List.of(new Layer(expired, Look.of(LUNG, 1)), new Layer(inspired, Look.of(INSPIRED, CLEAR)));
        TriangleMesh sheet = patient.diaphragm();
        try (LayersPicture layers = LayersPicture.open()) {
            return List.of(
                    layers.draw(
                            "fig4-" + file + "-levels",
                            "Lungs at the end of exhale within the clear, larger lungs at the end of inhale, from the front",
                            "Lungs at the end of exhale, and at the end of inhale (clear blue).",
                            levels,
                            shot(View.ANTERIOR)),
                    layers.draw(
                            "fig4-" + file + "-levels-side",
                            "The same from the patient's left",
                            "The same from the left.",
                            levels,
                            shot(View.LEFT)),
                    layers.draw(
                            "fig4-" + file + "-diaphragm",
                            "The diaphragm with the edges of its triangles below the clear lungs, from the front",
                            "Diaphragm and its mesh, lungs clear, end of exhale.",
                            List.of(
                                    new Layer(sheet, Look.of(SHEET, 1)),
                                    new Layer(sheet, Look.of(EDGES, 1).withWireframe(true)),
                                    new Layer(expired, Look.of(LUNG, CLEARER))),
                            shot(View.ANTERIOR)),
                    layers.draw(
                            "fig4-" + file + "-mesh",
                            "The lungs with the edges of their triangles, from the front",
                            "Lungs at the end of inhale and their mesh.",
                            List.of(
                                    new Layer(inspired, Look.of(LUNG, 1)),
                                    new Layer(inspired, Look.of(EDGES, 1).withWireframe(true))),
                            shot(View.ANTERIOR)));
        }
    }

    /** Lungs in colours of their distance from those at the end of inhale: without a model and with it, from the front and from below. */
    List<FigurePicture> distances() throws NoGraphicsException {
        DistanceSummary worst = patient.lungs().stream()
                .map(t -> t.initial().summary())
                .reduce((a, b) -> a.percentile95() > b.percentile95() ? a : b)
                .orElseThrow();
        List<FigurePicture> pictures = new ArrayList<>();
        for (View view : List.of(View.ANTERIOR, View.INFERIOR)) {
            pictures.add(coloured(FitResult.TargetResult::initial, "without", "End of exhale, no model", view, worst));
            pictures.add(coloured(FitResult.TargetResult::residual, "with", "Model, breathed in", view, worst));
        }
        return pictures;
    }

    private interface State {
        FitDistances of(FitResult.TargetResult lung);
    }

    private FigurePicture coloured(State state, String which, String what, View view, DistanceSummary worst)
            throws NoGraphicsException {
        double[] distances = patient.lungs().stream()
                .flatMapToDouble(lung -> DoubleStream.of(state.of(lung).toTarget()))
                .toArray();
        String from = view == View.ANTERIOR ? "from the front" : "from below";
        try (FieldPicture drawn = FieldPicture.open(lungs(state), distances)) {
            return drawn.figure(
                    "fig5-" + file + "-" + which + "-" + view.label(),
                    what + ": lungs in colours of their distance from those at the end of inhale, " + from,
                    what + ", " + from + ".",
                    shot(view),
                    FitPictures.scale(worst),
                    Meshes.merge(List.of(
                                    lungs(FitResult.TargetResult::initial), lungs(FitResult.TargetResult::residual)))
                            .bounds());
        }
    }

    private TriangleMesh lungs(State state) {
        return Meshes.merge(
                patient.lungs().stream().map(lung -> state.of(lung).model()).toList());
    }

    private Shot shot(View view) {
        // Wider than high, so that the scale stands beside the lungs.
        return Shot.of(view, size, size * 4 / 5, "");
    }
}
