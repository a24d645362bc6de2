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
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Overlay;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.Surface;

/**
 * Figures 1 and 3 of Villard, Bourne and Bello 2009, drawn anew: the thorax and the attachment points of its diaphragm; and the diaphragm's motion, its shape at the end of inhale as a wireframe over the
 * surface at the end of exhale.
 */
public final class PaperFigures {
    private static final int SAMPLES = 4;
    /** Bones over which attachment points are to be seen. */
    private static final float CLEAR_BONE = 0.35f;

    /** Surface through which the wireframe is to be seen. */
    private static final float CLEAR_SHEET = 0.28f;

    private static final double COLOUR_STEP_MM = 10;

    private final OffscreenGl gl;
    private final int width;
    private final int height;
    private final boolean letters = Annotations.canWrite();

    private PaperFigures(OffscreenGl gl, int width, int height) {
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
    public static Map<Integer, List<FigurePicture>> draw(
            Scenario own, Optional<Scenario> published, int width, SimulationRun.Progress progress)
            throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        try (OffscreenGl gl = OffscreenGl.open()) {
            PaperFigures figures = new PaperFigures(gl, width, width * 7 / 8);
            List<FigurePicture> first = new ArrayList<>();
            List<FigurePicture> third = new ArrayList<>();
            try (BreathEnds breath = new BreathEnds(own, progress)) {
                first.add(figures.anatomy(breath));
                first.add(figures.attachments(breath, View.ANTERIOR));
                first.add(figures.attachments(breath, View.POSTERIOR));
                third.add(figures.motion(breath, "fig3-motion", "Tissues.", false));
                third.add(figures.motion(breath, "fig3-displacement", "Way of each point from the wireframe.", true));
            }
            if (published.isPresent()) {
                try (BreathEnds breath = new BreathEnds(published.get(), progress)) {
                    third.add(figures.motion(breath, "fig3-paper-material", "With the paper's material.", false));
                }
            }
            return Map.of(1, first, 3, third);
        }
    }

    private FigurePicture anatomy(BreathEnds breath) {
        List<Surface> surfaces = breath.player().surfaces();
        SceneStyle style = SceneStyle.atlas(surfaces).withSamples(SAMPLES);
        style = new StructureSelection(surfaces).visible(style, "skin", false);
        style = new StructureSelection(surfaces).visible(style, "liver", false);
        Renderer renderer = new Renderer(surfaces, List.of());
        return new FigurePicture(
                "fig1-anatomy",
                "Rib cage, sternum, costal cartilages, spine, clear lungs and the two domes of the diaphragm from the front",
                "Thorax, from the front.",
                picture(renderer, breath.rest(), View.ANTERIOR, style, visible(surfaces, style)));
    }

    private FigurePicture attachments(BreathEnds breath, View view) {
        List<Surface> surfaces = breath.player().surfaces();
        Surface sheet = sheet(surfaces);
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withSamples(SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withOverlays(Set.of(Overlay.Kind.ATTACHMENTS));
        for (Surface s : surfaces) {
            Look look = style.look(s.name()).orElseThrow();
            style = switch (s.kind()) {
                case DIAPHRAGM -> style;
                case RIB, COSTAL_CARTILAGE, STERNUM, VERTEBRA, DISC ->
                    style.withLook(s.name(), look.withOpacity(CLEAR_BONE));
                case LUNG, LIVER, SKIN, OTHER -> style.withLook(s.name(), look.withVisible(false));
            };
        }
        Renderer renderer =
                new Renderer(surfaces, List.of(ofSheet(breath.player().overlays(), sheet)));
        return new FigurePicture(
                "fig1-attachments-" + view.label(),
                "The diaphragm below clear bones with orange points along its border, seen from the "
                        + (view == View.ANTERIOR ? "front" : "back"),
                view == View.ANTERIOR ? "Attachment points, from the front." : "The same from behind.",
                picture(renderer, breath.rest(), view, style, List.of(sheet)));
    }

    /** Of all points at which bone holds something those of the sheet: its nodes come first. */
    private static Overlay ofSheet(List<Overlay> overlays, Surface sheet) {
        int[] held = overlays.stream()
                .filter(o -> o.kind() == Overlay.Kind.ATTACHMENTS)
                .flatMapToInt(o -> Arrays.stream(o.nodePairs()))
                .filter(node -> node < sheet.rest().vertexCount())
                .toArray();
        return new Overlay(Overlay.Kind.ATTACHMENTS, held, new float[0]);
    }

    private FigurePicture motion(BreathEnds breath, String name, String caption, boolean coloured) {
        List<Surface> given = breath.player().surfaces();
        int index = given.indexOf(sheet(given));
        Surface sheet = given.get(index);
        double[] start = new double[sheet.rest().positions().length];
        breath.inspired().place(sheet, index, start);
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
            Look look = style.look(s.name()).orElseThrow();
            style = style.withLook(
                    s.name(),
                    s.name().equals(sheet.name())
                            ? look.withOpacity(coloured ? 1 : CLEAR_SHEET)
                            : look.withVisible(false));
        }
        if (coloured) {
            double most = COLOUR_STEP_MM * Math.ceil(farthest(sheet, index, start, breath.expired()) / COLOUR_STEP_MM);
            style = style.withField(
                    ColourField.DISPLACEMENT,
                    sheet.name(),
                    ColourScale.magnitude(most, ColourField.DISPLACEMENT.unit()));
        }
        return new FigurePicture(
                name,
                "Wireframe of the diaphragm at the end of inhale over its surface at the end of exhale, whose domes stand"
                        + " higher" + (coloured ? ", coloured by displacement" : ", muscle red and tendon pale"),
                caption,
                picture(
                        new Renderer(surfaces, List.of()),
                        breath.expired(),
                        View.ANTERIOR,
                        style,
                        List.of(begun, sheet)));
    }

    private static double farthest(Surface sheet, int index, double[] from, Frame frame) {
        double[] to = new double[from.length];
        frame.place(sheet, index, to);
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

    private static Surface sheet(List<Surface> surfaces) {
        return surfaces.stream()
                .filter(s -> s.kind() == StructureKind.DIAPHRAGM)
                .findFirst()
                .orElseThrow();
    }

    private static List<Surface> visible(List<Surface> surfaces, SceneStyle style) {
        return surfaces.stream()
                .filter(s -> style.look(s.name()).filter(Look::visible).isPresent())
                .toList();
    }

    private BufferedImage picture(Renderer renderer, Frame frame, View view, SceneStyle style, List<Surface> framed) {
        Camera camera = Camera.of(view, SceneBounds.of(framed), (double) width / height);
        BufferedImage image = gl.picture(renderer, frame, camera, style, width, height);
        gl.release(renderer);
        if (letters) {
            Annotations plain = Annotations.on(style.background() == Background.LIGHT);
            (style.field() == ColourField.NONE
                            ? plain
                            : plain.withScale(style.field().label(), style.scale()))
                    .draw(image, camera);
        }
        return image;
    }
}
