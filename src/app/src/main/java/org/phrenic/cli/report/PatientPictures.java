package org.phrenic.cli.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.DoubleStream;
import org.phrenic.fit.FitDistances;
import org.phrenic.fit.FitResult;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.scene.DistanceMapPictures;
import org.phrenic.scene.LayeredPictures;
import org.phrenic.scene.LayeredPictures.Layer;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.Appearance;
import org.phrenic.study.paper.PatientCase;

/** Figures 4 and 5 of the paper for a patient of ours. */
public final class PatientPictures {
    private static final int LUNG = 0xd98f86;
    private static final int INSPIRED = 0x2f74b5;
    private static final int SHEET = 0xb9483c;
    private static final int EDGES = 0x27303a;
    private static final float TRANSLUCENT_OPACITY = 0.3f;
    private static final float FAINT_OPACITY = 0.16f;

    private final PatientCase patient;
    private final int size;
    private final String file;

    public PatientPictures(PatientCase patient, int size) {
        this.patient = patient;
        this.size = size;
        file = patient.name().toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
    }

    /** Lungs at both breath levels, and the diaphragm's mesh below them. */
    public List<FigureImage> segmentationFigures() throws NoGraphicsException {
        TriangleMesh expired = lungs(FitResult.TargetResult::initial);
        TriangleMesh inspired = MeshMerge.merge(
                patient.lungs().stream().map(t -> t.target().surface()).toList());
        List<Layer> levels = List.of(
                new Layer(expired, Appearance.of(LUNG, 1)),
                new Layer(inspired, Appearance.of(INSPIRED, TRANSLUCENT_OPACITY)));
        TriangleMesh sheet = patient.diaphragm();
        try (LayeredPictures layers = LayeredPictures.open()) {
            return List.of(
                    layers.draw(
                            "fig4-" + file + "-levels",
                            "Lungs at the end of exhale within the clear, larger lungs at the end of inhale, from the front",
                            "Lungs at the end of exhale, and at the end of inhale (clear blue).",
                            levels,
                            shot(AnatomicalView.ANTERIOR)),
                    layers.draw(
                            "fig4-" + file + "-levels-side",
                            "The same from the patient's left",
                            "The same from the left.",
                            levels,
                            shot(AnatomicalView.LEFT)),
                    layers.draw(
                            "fig4-" + file + "-diaphragm",
                            "The diaphragm with the edges of its triangles below the clear lungs, from the front",
                            "Diaphragm and its mesh, lungs clear, end of exhale.",
                            List.of(
                                    new Layer(sheet, Appearance.of(SHEET, 1)),
                                    new Layer(sheet, Appearance.of(EDGES, 1).withWireframe(true)),
                                    new Layer(expired, Appearance.of(LUNG, FAINT_OPACITY))),
                            shot(AnatomicalView.ANTERIOR)),
                    layers.draw(
                            "fig4-" + file + "-mesh",
                            "The lungs with the edges of their triangles, from the front",
                            "Lungs at the end of inhale and their mesh.",
                            List.of(
                                    new Layer(inspired, Appearance.of(LUNG, 1)),
                                    new Layer(inspired, Appearance.of(EDGES, 1).withWireframe(true))),
                            shot(AnatomicalView.ANTERIOR)));
        }
    }

    /**
     * Lungs in colours of their distance from those at the end of inhale: without a model and with it, from the front
     * and from below.
     */
    public List<FigureImage> distanceFigures() throws NoGraphicsException {
        DistanceSummary worst = patient.lungs().stream()
                .map(t -> t.initial().summary())
                .reduce((a, b) -> a.percentile95() > b.percentile95() ? a : b)
                .orElseThrow();
        List<FigureImage> pictures = new ArrayList<>();
        for (AnatomicalView view : List.of(AnatomicalView.ANTERIOR, AnatomicalView.INFERIOR)) {
            pictures.add(coloured(FitResult.TargetResult::initial, "without", "End of exhale, no model", view, worst));
            pictures.add(coloured(FitResult.TargetResult::residual, "with", "Model, breathed in", view, worst));
        }
        return pictures;
    }

    private interface State {
        FitDistances of(FitResult.TargetResult lung);
    }

    private FigureImage coloured(State state, String which, String what, AnatomicalView view, DistanceSummary worst)
            throws NoGraphicsException {
        double[] distances = patient.lungs().stream()
                .flatMapToDouble(lung -> DoubleStream.of(state.of(lung).toTarget()))
                .toArray();
        String from = view == AnatomicalView.ANTERIOR ? "from the front" : "from below";
        try (DistanceMapPictures drawn = DistanceMapPictures.open(lungs(state), distances)) {
            return drawn.render(
                    "fig5-" + file + "-" + which + "-" + view.label(),
                    what + ": lungs in colours of their distance from those at the end of inhale, " + from,
                    what + ", " + from + ".",
                    shot(view),
                    FitPictures.scale(worst),
                    MeshMerge.merge(List.of(
                                    lungs(FitResult.TargetResult::initial), lungs(FitResult.TargetResult::residual)))
                            .bounds());
        }
    }

    private TriangleMesh lungs(State state) {
        return MeshMerge.merge(
                patient.lungs().stream().map(lung -> state.of(lung).model()).toList());
    }

    private PictureSettings shot(AnatomicalView view) {
        // Wider than high, so that the scale stands beside the lungs.
        return PictureSettings.of(view, size, size * 4 / 5, "");
    }
}
