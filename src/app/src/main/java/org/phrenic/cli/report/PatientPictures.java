package org.phrenic.cli.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import org.phrenic.fit.FitDistances;
import org.phrenic.fit.FitResult;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshMerge;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.scene.SurfacePictures;
import org.phrenic.scene.SurfacePictures.Layer;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.study.paper.PatientCase;

/** Reproduces figures 4 and 5 of Villard, Bourne and Bello 2009 for a patient. */
public final class PatientPictures {
    private static final int LUNG = 0xd98f86;
    private static final int INSPIRED = 0x2f74b5;
    private static final int DIAPHRAGM = 0xb9483c;
    private static final int EDGES = 0x27303a;
    private static final float TRANSLUCENT_OPACITY = 0.3f;
    private static final float FAINT_OPACITY = 0.16f;

    private final PatientCase patient;
    private final int size;
    private final String file;

    /**
     * @param patient that is shown
     * @param number of the patient in the report, from 1
     * @param size width of the pictures, pixels
     */
    public PatientPictures(PatientCase patient, int number, int size) {
        this.patient = patient;
        this.size = size;
        file = fileName(number, patient.name());
    }

    /** Part of a file's name: the number tells apart patients of whose names the same letters are left. */
    static String fileName(int number, String patient) {
        String letters = patient.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
        return (number + "-" + letters).replaceAll("-+", "-").replaceAll("-$", "");
    }

    /** Figure 4: the lungs at both breath levels and the diaphragm mesh below them. */
    public List<FigureImage> segmentationFigures() throws NoGraphicsException {
        TriangleMesh expired = lungs(FitResult.TargetResult::initial);
        TriangleMesh inspired = MeshMerge.merge(
                patient.lungs().stream().map(t -> t.target().surface()).toList());
        TriangleMesh diaphragm = patient.diaphragm();
        Appearance edges = Appearance.of(EDGES, 1).withWireframe(true);
        List<Layer> levels = List.of(
                new Layer(expired, Appearance.of(LUNG, 1)),
                new Layer(inspired, Appearance.of(INSPIRED, TRANSLUCENT_OPACITY)));
        List<Layer> mesh = List.of(
                new Layer(diaphragm, Appearance.of(DIAPHRAGM, 1)),
                new Layer(diaphragm, edges),
                new Layer(expired, Appearance.of(LUNG, FAINT_OPACITY)));
        List<Layer> lungMesh = List.of(new Layer(inspired, Appearance.of(LUNG, 1)), new Layer(inspired, edges));
        try (SurfacePictures pictures = new SurfacePictures()) {
            return List.of(
                    new FigureImage(
                            "fig4-" + file + "-levels",
                            "Lungs at the end of exhale within the translucent, larger lungs at the end of inhale, from"
                                    + " the front",
                            "Lungs at the end of exhale, and at the end of inhale (translucent blue).",
                            pictures.layers(levels, settings(AnatomicalView.ANTERIOR))),
                    new FigureImage(
                            "fig4-" + file + "-levels-side",
                            "The same from the patient's left",
                            "The same from the left.",
                            pictures.layers(levels, settings(AnatomicalView.LEFT))),
                    new FigureImage(
                            "fig4-" + file + "-diaphragm",
                            "The diaphragm with the edges of its triangles below the translucent lungs, from the front",
                            "Diaphragm and its mesh, lungs translucent, end of exhale.",
                            pictures.layers(mesh, settings(AnatomicalView.ANTERIOR))),
                    new FigureImage(
                            "fig4-" + file + "-mesh",
                            "The lungs with the edges of their triangles, from the front",
                            "Lungs at the end of inhale and their mesh.",
                            pictures.layers(lungMesh, settings(AnatomicalView.ANTERIOR))));
        }
    }

    /**
     * Figure 5: the lungs coloured by their distance from the lungs at the end of inhale, without and with the model,
     * from the front and from below.
     */
    public List<FigureImage> distanceFigures() throws NoGraphicsException {
        DistanceSummary worst = patient.lungs().stream()
                .map(t -> t.initial().summary())
                .max(Comparator.comparingDouble(DistanceSummary::percentile95))
                .orElseThrow();
        TriangleMesh initial = lungs(FitResult.TargetResult::initial);
        TriangleMesh fitted = lungs(FitResult.TargetResult::residual);
        double[] bounds = MeshMerge.merge(List.of(initial, fitted)).bounds();
        List<FigureImage> figures = new ArrayList<>();
        try (SurfacePictures pictures = new SurfacePictures()) {
            for (AnatomicalView view : List.of(AnatomicalView.ANTERIOR, AnatomicalView.INFERIOR)) {
                String from = view == AnatomicalView.ANTERIOR ? "from the front" : "from below";
                for (State state : State.values()) {
                    double[] distances = patient.lungs().stream()
                            .flatMapToDouble(
                                    lung -> DoubleStream.of(state.of.apply(lung).toTarget()))
                            .toArray();
                    ColourScale scale = FitPictures.scale(worst);
                    figures.add(new FigureImage(
                            "fig5-" + file + "-" + state.label + "-" + view.label(),
                            state.caption + ": lungs in colours of their distance from those at the end of inhale, "
                                    + from,
                            state.caption + ", " + from + ".",
                            pictures.distances(lungs(state.of), distances, settings(view), scale, bounds)));
                }
            }
        }
        return figures;
    }

    private enum State {
        INITIAL("without", "End of exhale, no model", FitResult.TargetResult::initial),
        FITTED("with", "Model, breathed in", FitResult.TargetResult::residual);

        private final String label;
        private final String caption;
        private final Function<FitResult.TargetResult, FitDistances> of;

        State(String label, String caption, Function<FitResult.TargetResult, FitDistances> of) {
            this.label = label;
            this.caption = caption;
            this.of = of;
        }
    }

    private TriangleMesh lungs(Function<FitResult.TargetResult, FitDistances> state) {
        return MeshMerge.merge(
                patient.lungs().stream().map(lung -> state.apply(lung).model()).toList());
    }

    /** The picture is wider than high, which leaves room for the colour bar beside the lungs. */
    private PictureSettings settings(AnatomicalView view) {
        return PictureSettings.of(view, size, size * 4 / 5, "");
    }
}
