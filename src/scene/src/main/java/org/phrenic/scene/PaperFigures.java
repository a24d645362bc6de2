package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.joml.Vector3d;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureSelection;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Observation;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Reproduces figures 1 and 3 of Villard, Bourne and Bello 2009. Figure 1 shows the thorax and the attachment points of
 * the diaphragm. Figure 3 shows the motion of the diaphragm: end of inhale as a wireframe over the surface at end of
 * exhale.
 */
public final class PaperFigures {
    private static final float BONE_OPACITY = 0.35f;
    private static final float DIAPHRAGM_OPACITY = 0.28f;
    private static final double COLOUR_STEP_MM = 10;
    private static final double SAMPLE_INTERVAL_S = 0.05;
    private static final int BREATH = Observation.COLUMNS.indexOf("breath");
    private static final int RIGHT = Observation.COLUMNS.indexOf("dome_right_mm");
    private static final int LEFT = Observation.COLUMNS.indexOf("dome_left_mm");

    private final OffscreenContext gl;
    private final int width;
    private final int height;

    private PaperFigures(OffscreenContext gl, int width, int height) {
        this.gl = gl;
        this.width = width;
        this.height = height;
    }

    /**
     * Frames of a scenario's first breath: rest, end of inhale (minimum of the sum of both dome heights), and end.
     *
     * @param surfaces surfaces, in the order of the frames
     */
    private record Breath(List<Surface> surfaces, List<Overlay> overlays, Frame rest, Frame inhaled, Frame exhaled) {
        static Breath of(Scenario scenario, SimulationRun.Progress progress) {
            try (ScenePlayer player = new ScenePlayer(scenario, progress)) {
                Frame rest = player.advanceTo(0).copy();
                Frame inhaled = rest.copy();
                Frame now = player.advanceTo(0);
                double breath = rest.values()[BREATH];
                for (int i = 1; now.values()[BREATH] == breath && now.timeS() < player.durationS(); i++) {
                    now = player.advanceTo(i * SAMPLE_INTERVAL_S);
                    if (domeHeightSum(now) < domeHeightSum(inhaled)) {
                        inhaled.copyFrom(now);
                    }
                }
                return new Breath(player.surfaces(), player.overlays(), rest, inhaled, now.copy());
            }
        }

        private static double domeHeightSum(Frame frame) {
            return frame.values()[RIGHT] + frame.values()[LEFT];
        }

        Surface diaphragm() {
            return StructureSelection.first(surfaces, StructureKind.DIAPHRAGM);
        }
    }

    /**
     * Draws the figures.
     *
     * @param own scenario with the default material of this program
     * @param published scenario with the material of the paper; empty to omit it
     * @param width width of a picture, pixels
     * @return pictures by figure number
     * @throws NoGraphicsException if no OpenGL context is available, before any simulation; the message is one sentence
     */
    public static Map<Integer, List<FigureImage>> draw(
            Scenario own, Optional<Scenario> published, int width, SimulationRun.Progress progress)
            throws NoGraphicsException {
        try (OffscreenContext gl = OffscreenContext.headless()) {
            PaperFigures figures = new PaperFigures(gl, width, width * 7 / 8);
            Breath breath = Breath.of(own, progress);
            List<FigureImage> first = List.of(
                    figures.anatomy(breath),
                    figures.attachments(breath, AnatomicalView.ANTERIOR),
                    figures.attachments(breath, AnatomicalView.POSTERIOR));
            List<FigureImage> third = new ArrayList<>();
            third.add(figures.motion(breath, "fig3-motion", "Tissues.", false));
            String coloured = "Displacement of each point from the wireframe.";
            third.add(figures.motion(breath, "fig3-displacement", coloured, true));
            published
                    .map(scenario -> Breath.of(scenario, progress))
                    .map(b -> figures.motion(b, "fig3-paper-material", "With the paper's material.", false))
                    .ifPresent(third::add);
            return Map.of(1, first, 3, third);
        }
    }

    private FigureImage anatomy(Breath breath) {
        List<Surface> surfaces = breath.surfaces;
        StructureSelection selection = new StructureSelection(surfaces);
        SceneStyle atlas = SceneStyle.atlas(surfaces).withSamples(SceneStyle.SMOOTH_SAMPLES);
        SceneStyle style = selection.withVisibility(selection.withVisibility(atlas, "skin", false), "liver", false);
        Renderer renderer = new Renderer(surfaces, List.of());
        return new FigureImage(
                "fig1-anatomy",
                "Rib cage, sternum, costal cartilages, spine, translucent lungs and the two domes of the diaphragm from"
                        + " the front",
                "Thorax, from the front.",
                picture(renderer, breath.rest, AnatomicalView.ANTERIOR, style, style.visible(surfaces)));
    }

    private FigureImage attachments(Breath breath, AnatomicalView view) {
        Surface diaphragm = breath.diaphragm();
        SceneStyle style = SceneStyle.atlas(breath.surfaces)
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withOverlays(Set.of(Overlay.Kind.ATTACHMENTS))
                .withAppearances(breath.surfaces, (s, usual) -> switch (s.kind()) {
                    case DIAPHRAGM -> usual;
                    case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC -> usual.withOpacity(BONE_OPACITY);
                    default -> usual.withVisible(false);
                });
        // The first nodes of the scene belong to the diaphragm.
        int[] nodes = breath.overlays.stream()
                .filter(o -> o.kind() == Overlay.Kind.ATTACHMENTS)
                .flatMapToInt(o -> Arrays.stream(o.nodePairs()))
                .filter(node -> node < diaphragm.rest().vertexCount())
                .toArray();
        Overlay attachments = new Overlay(Overlay.Kind.ATTACHMENTS, nodes, new float[0]);
        Renderer renderer = new Renderer(breath.surfaces, List.of(attachments));
        boolean front = view == AnatomicalView.ANTERIOR;
        return new FigureImage(
                "fig1-attachments-" + view.label(),
                "The diaphragm below translucent bones with orange points along its border, seen from the "
                        + (front ? "front" : "back"),
                front ? "Attachment points, from the front." : "The same from behind.",
                picture(renderer, breath.rest, view, style, List.of(diaphragm)));
    }

    private FigureImage motion(Breath breath, String name, String caption, boolean coloured) {
        Surface diaphragm = breath.diaphragm();
        int index = breath.surfaces.indexOf(diaphragm);
        double[] start = new double[diaphragm.rest().positions().length];
        breath.inhaled.writePositions(diaphragm, index, start);
        // The end of inhale is the rest shape, to which wireframe and displacement refer.
        Surface inhaled = new Surface(
                diaphragm.name(),
                diaphragm.kind(),
                diaphragm.level(),
                diaphragm.side(),
                diaphragm.rest().withPositions(start),
                diaphragm.motion(),
                diaphragm.tendon());
        List<Surface> surfaces = new ArrayList<>(breath.surfaces);
        surfaces.set(index, inhaled);
        Appearance usual = SurfaceMaterial.of(inhaled.kind()).appearance();
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withRestWireframe(true)
                .withAppearances(surfaces, (s, look) -> look.withVisible(false))
                .withAppearance(inhaled.name(), usual.withOpacity(coloured ? 1 : DIAPHRAGM_OPACITY));
        if (coloured) {
            double[] end = new double[start.length];
            breath.exhaled.writePositions(diaphragm, index, end);
            double range = COLOUR_STEP_MM * Math.ceil(maxDistance(start, end) / COLOUR_STEP_MM);
            ColourScale scale = ColourScale.sequential(range, ColourField.DISPLACEMENT.unit());
            style = style.withField(ColourField.DISPLACEMENT, diaphragm.name(), scale);
        }
        Renderer renderer = new Renderer(surfaces, List.of());
        return new FigureImage(
                name,
                "Wireframe of the diaphragm at the end of inhale over its surface at the end of exhale, whose domes"
                        + " stand higher" + (coloured ? ", coloured by displacement" : ", muscle red and tendon pale"),
                caption,
                picture(renderer, breath.exhaled, AnatomicalView.ANTERIOR, style, List.of(inhaled, diaphragm)));
    }

    private static double maxDistance(double[] from, double[] to) {
        double max = 0;
        for (int i = 0; i < from.length; i += 3) {
            max = Math.max(max, Vector3d.distance(from[i], from[i + 1], from[i + 2], to[i], to[i + 1], to[i + 2]));
        }
        return max;
    }

    private BufferedImage picture(
            Renderer renderer, Frame frame, AnatomicalView view, SceneStyle style, List<Surface> framed) {
        Camera camera = Camera.of(view, Surface.bounds(framed), (double) width / height);
        BufferedImage image = gl.render(renderer, frame, camera, style, width, height);
        gl.release(renderer);
        Annotations.of(style).draw(image, camera);
        return image;
    }
}
