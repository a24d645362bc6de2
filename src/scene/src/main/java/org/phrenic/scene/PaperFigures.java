package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
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
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.StructureSelection;
import org.phrenic.scene.style.Transparency;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/**
 * Figures 1 and 3 of Villard, Bourne and Bello 2009, drawn anew: the thorax and the attachment points of its diaphragm;
 * and the diaphragm's motion, its shape at the end of inhale as a wireframe over the surface at the end of exhale.
 */
public final class PaperFigures {
    private static final int SAMPLES = 4;
    /** Bones over which attachment points are to be seen. */
    private static final float BONE_OPACITY = 0.35f;

    /** Surface through which the wireframe is to be seen. */
    private static final float DIAPHRAGM_OPACITY = 0.28f;

    private static final double COLOUR_STEP_MM = 10;

    private final OffscreenContext gl;
    private final int width;
    private final int height;
    private final boolean letters = Annotations.hasFonts();

    private PaperFigures(OffscreenContext gl, int width, int height) {
        this.gl = gl;
        this.width = width;
        this.height = height;
    }

    /**
     * Draws them.
     *
     * @param own a breath of the model as it is used here
     * @param published one with the paper's material; empty to leave it out
     * @param width of a picture, pixels
     * @return pictures by the number of their figure
     * @throws NoGraphicsException if nothing here draws, with one sentence; nothing was simulated then
     */
    public static Map<Integer, List<FigureImage>> draw(
            Scenario own, Optional<Scenario> published, int width, SimulationRun.Progress progress)
            throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        try (OffscreenContext gl = OffscreenContext.open()) {
            PaperFigures figures = new PaperFigures(gl, width, width * 7 / 8);
            List<FigureImage> first = new ArrayList<>();
            List<FigureImage> third = new ArrayList<>();
            try (BreathExtremes breath = new BreathExtremes(own, progress)) {
                first.add(figures.anatomy(breath));
                first.add(figures.attachments(breath, AnatomicalView.ANTERIOR));
                first.add(figures.attachments(breath, AnatomicalView.POSTERIOR));
                third.add(figures.motion(breath, "fig3-motion", "Tissues.", false));
                third.add(figures.motion(breath, "fig3-displacement", "Way of each point from the wireframe.", true));
            }
            if (published.isPresent()) {
                try (BreathExtremes breath = new BreathExtremes(published.get(), progress)) {
                    third.add(figures.motion(breath, "fig3-paper-material", "With the paper's material.", false));
                }
            }
            return Map.of(1, first, 3, third);
        }
    }

    private FigureImage anatomy(BreathExtremes breath) {
        List<Surface> surfaces = breath.player().surfaces();
        SceneStyle style = SceneStyle.atlas(surfaces).withSamples(SAMPLES);
        style = new StructureSelection(surfaces).withVisibility(style, "skin", false);
        style = new StructureSelection(surfaces).withVisibility(style, "liver", false);
        Renderer renderer = new Renderer(surfaces, List.of());
        return new FigureImage(
                "fig1-anatomy",
                "Rib cage, sternum, costal cartilages, spine, clear lungs and the two domes of the diaphragm from the front",
                "Thorax, from the front.",
                picture(renderer, breath.rest(), AnatomicalView.ANTERIOR, style, visible(surfaces, style)));
    }

    private FigureImage attachments(BreathExtremes breath, AnatomicalView view) {
        List<Surface> surfaces = breath.player().surfaces();
        Surface sheet = diaphragm(surfaces);
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withSamples(SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withOverlays(Set.of(Overlay.Kind.ATTACHMENTS));
        for (Surface s : surfaces) {
            Appearance look = style.appearance(s.name()).orElseThrow();
            style = switch (s.kind()) {
                case DIAPHRAGM -> style;
                case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC ->
                    style.withAppearance(s.name(), look.withOpacity(BONE_OPACITY));
                case LUNG, LIVER, SKIN, OTHER -> style.withAppearance(s.name(), look.withVisible(false));
            };
        }
        Renderer renderer = new Renderer(
                surfaces, List.of(diaphragmAttachments(breath.player().overlays(), sheet)));
        return new FigureImage(
                "fig1-attachments-" + view.label(),
                "The diaphragm below clear bones with orange points along its border, seen from the "
                        + (view == AnatomicalView.ANTERIOR ? "front" : "back"),
                view == AnatomicalView.ANTERIOR ? "Attachment points, from the front." : "The same from behind.",
                picture(renderer, breath.rest(), view, style, List.of(sheet)));
    }

    /** Of all points at which bone holds something those of the sheet: its nodes come first. */
    private static Overlay diaphragmAttachments(List<Overlay> overlays, Surface sheet) {
        int[] held = overlays.stream()
                .filter(o -> o.kind() == Overlay.Kind.ATTACHMENTS)
                .flatMapToInt(o -> Arrays.stream(o.nodePairs()))
                .filter(node -> node < sheet.rest().vertexCount())
                .toArray();
        return new Overlay(Overlay.Kind.ATTACHMENTS, held, new float[0]);
    }

    private FigureImage motion(BreathExtremes breath, String name, String caption, boolean coloured) {
        List<Surface> given = breath.player().surfaces();
        int index = given.indexOf(diaphragm(given));
        Surface sheet = given.get(index);
        double[] start = new double[sheet.rest().positions().length];
        breath.endInspiration().writePositions(sheet, index, start);
        // What the wireframe shows, and what displacement is measured from, is here the end of inhale.
        Surface begun = new Surface(
                sheet.name(),
                sheet.kind(),
                sheet.level(),
                sheet.side(),
                sheet.rest().withPositions(start),
                sheet.motion(),
                sheet.tendon());
        List<Surface> surfaces = new ArrayList<>(given);
        surfaces.set(index, begun);
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withSamples(SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withRestWireframe(true);
        for (Surface s : surfaces) {
            Appearance look = style.appearance(s.name()).orElseThrow();
            style = style.withAppearance(
                    s.name(),
                    s.name().equals(sheet.name())
                            ? look.withOpacity(coloured ? 1 : DIAPHRAGM_OPACITY)
                            : look.withVisible(false));
        }
        if (coloured) {
            double most = COLOUR_STEP_MM
                    * Math.ceil(maxDisplacement(sheet, index, start, breath.endExpiration()) / COLOUR_STEP_MM);
            style = style.withField(
                    ColourField.DISPLACEMENT,
                    sheet.name(),
                    ColourScale.sequential(most, ColourField.DISPLACEMENT.unit()));
        }
        return new FigureImage(
                name,
                "Wireframe of the diaphragm at the end of inhale over its surface at the end of exhale, whose domes stand"
                        + " higher" + (coloured ? ", coloured by displacement" : ", muscle red and tendon pale"),
                caption,
                picture(
                        new Renderer(surfaces, List.of()),
                        breath.endExpiration(),
                        AnatomicalView.ANTERIOR,
                        style,
                        List.of(begun, sheet)));
    }

    private static double maxDisplacement(Surface sheet, int index, double[] from, Frame frame) {
        double[] to = new double[from.length];
        frame.writePositions(sheet, index, to);
        return IntStream.range(0, from.length / 3)
                .mapToDouble(i -> Math.sqrt(square(to[3 * i] - from[3 * i])
                        + square(to[3 * i + 1] - from[3 * i + 1])
                        + square(to[3 * i + 2] - from[3 * i + 2])))
                .max()
                .orElse(0);
    }

    private static double square(double value) {
        return value * value;
    }

    private static Surface diaphragm(List<Surface> surfaces) {
        return surfaces.stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow();
    }

    private static List<Surface> visible(List<Surface> surfaces, SceneStyle style) {
        return surfaces.stream()
                .filter(s ->
                        style.appearance(s.name()).filter(Appearance::visible).isPresent())
                .toList();
    }

    private BufferedImage picture(
            Renderer renderer, Frame frame, AnatomicalView view, SceneStyle style, List<Surface> framed) {
        Camera camera = Camera.of(view, SceneBounds.of(framed), (double) width / height);
        BufferedImage image = gl.render(renderer, frame, camera, style, width, height);
        gl.release(renderer);
        if (letters) {
            Annotations plain = Annotations.forBackground(style.background() == SceneBackground.LIGHT);
            (style.field() == ColourField.NONE
                            ? plain
                            : plain.withScale(style.field().label(), style.scale()))
                    .draw(image, camera);
        }
        return image;
    }
}
