package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.rehearsal.AccessMap;
import org.phrenic.rehearsal.NeedleView;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** Pictures of a rehearsal without a window: the needle in the body, whole and cut open in a plane along the needle, and the access map on the skin. */
public final class NeedlePictures implements AutoCloseable {
    private static final int SIZE = 720;
    private static final int SAMPLES = 4;
    private static final String NEEDLE = "needle";
    private static final String TARGET = "target";
    /** Drawn thicker than it is, so that it is seen. */
    private static final double DRAWN_RADIUS_MM = 1.2;

    static final Look NEEDLE_LOOK = Look.of(0x1f4e79, 1);
    static final Look TARGET_LOOK = Look.of(0xf2c500, 1);

    private final OffscreenGl gl;
    private final List<Surface> body;
    private final boolean own;

    private NeedlePictures(OffscreenGl gl, List<Surface> body, boolean own) {
        this.gl = gl;
        this.body = body;
        this.own = own;
    }

    /** Draws with what draws already, on its thread. */
    public static NeedlePictures with(OffscreenGl gl, List<Surface> body) {
        return new NeedlePictures(gl, body, false);
    }

    /**
     * Finds something that draws.
     *
     * @param body surfaces of the frames
     * @throws NoGraphicsException if nothing here draws, with one sentence
     */
    public static NeedlePictures open(List<Surface> body) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return new NeedlePictures(OffscreenGl.open(), body, true);
    }

    /**
     * Writes the needle at one moment from the front, from the right and cut open along it.
     *
     * @return names of the files
     */
    public List<String> needle(Path folder, NeedleView view, String title) {
        List<Surface> all = new ArrayList<>(body);
        all.add(Markers.rod(NEEDLE, view.hub(), view.tip(), DRAWN_RADIUS_MM));
        all.add(Markers.ball(TARGET, view.target(), view.targetRadiusMm()));
        Renderer renderer = new Renderer(all, List.of());
        SceneStyle style = seenThrough(all);
        List<String> names = new ArrayList<>();
        String moment =
                Annotations.moment(view.frame().timeS(), view.label().name().toLowerCase(Locale.ROOT));
        names.add(
                write(folder, view.name() + "_anterior", renderer, view.frame(), View.ANTERIOR, style, title, moment));
        names.add(write(folder, view.name() + "_right", renderer, view.frame(), View.RIGHT, style, title, moment));
        names.add(write(
                folder,
                view.name() + "_section",
                renderer,
                view.frame(),
                View.INFERIOR,
                cut(all, view),
                title + ", cut open along the needle",
                moment));
        gl.release(renderer);
        return names;
    }

    /** Bone, diaphragm and liver to be looked through, so that nothing hides needle and target. */
    private static SceneStyle seenThrough(List<Surface> all) {
        Map<String, Look> looks = new LinkedHashMap<>();
        for (Surface s : all) {
            Look look = Material.of(s.kind()).look();
            looks.put(
                    s.name(),
                    switch (s.kind()) {
                        case LIVER -> look.withOpacity(0.38f);
                        case DIAPHRAGM -> look.withOpacity(0.16f);
                        case LUNG -> look.withOpacity(0.25f);
                        case SKIN -> look.withOpacity(0.10f);
                        case RIB, COSTAL_CARTILAGE, STERNUM -> look.withOpacity(0.55f);
                        case VERTEBRA, DISC, OTHER -> look;
                    });
        }
        looks.put(NEEDLE, NEEDLE_LOOK);
        looks.put(TARGET, TARGET_LOOK);
        return SceneStyle.atlas(all).withLooks(looks).withSamples(SAMPLES).withTransparency(Transparency.PEELED);
    }

    /** A plane that holds the needle and is as level as it can be; what lies below is left out, so that it is seen as an axial slice is. */
    private static SceneStyle cut(List<Surface> all, NeedleView view) {
        double[] d = {view.tip()[0] - view.hub()[0], view.tip()[1] - view.hub()[1], view.tip()[2] - view.hub()[2]};
        double flat = Math.sqrt(d[0] * d[0] + d[1] * d[1]);
        // At a right angle to the needle and to the level direction across it.
        double nx = flat > 0 ? -d[2] * d[0] / flat : 0;
        double ny = flat > 0 ? -d[2] * d[1] / flat : 1;
        double nz = flat;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double[] p = view.tip();
        double offset = (nx * p[0] + ny * p[1] + nz * p[2]) / length;
        Map<String, Look> looks = new LinkedHashMap<>();
        for (Surface s : all) {
            Look look = Material.of(s.kind()).look();
            looks.put(
                    s.name(),
                    switch (s.kind()) {
                        case LUNG, LIVER -> look.withOpacity(1);
                        default -> look;
                    });
        }
        looks.put(NEEDLE, NEEDLE_LOOK);
        looks.put(TARGET, TARGET_LOOK);
        return SceneStyle.atlas(all)
                .withLooks(looks)
                .withSamples(SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withClip(Optional.of(new ClipPlane(-nx, -ny, -nz, -offset)));
    }

    /**
     * Writes the access map on the skin at the first moment, from the front, the right and behind.
     *
     * @return names of the files
     */
    public List<String> map(Path folder, AccessMap map, String title) {
        Renderer renderer = new Renderer(body, List.of());
        String skin = body.stream()
                .filter(s -> s.kind() == StructureKind.SKIN)
                .map(Surface::name)
                .findFirst()
                .orElseThrow();
        renderer.setField(skin, map.freePercent());
        ColourScale scale = ColourScale.magnitude(100, ColourField.ACCESS.unit());
        SceneStyle style = SceneStyle.atlas(body)
                .withLooks(Map.of(skin, Material.of(StructureKind.SKIN).look().withOpacity(1)))
                .withSamples(SAMPLES)
                .withField(ColourField.ACCESS, skin, scale)
                .withOverlays(Set.of());
        Frame frame = map.cycle().get(0).frame();
        List<String> names = new ArrayList<>();
        for (View view : List.of(View.ANTERIOR, View.RIGHT, View.POSTERIOR)) {
            names.add(write(folder, "access_" + view.label(), renderer, frame, view, style, title, ""));
        }
        gl.release(renderer);
        return names;
    }

    private String write(
            Path folder,
            String name,
            Renderer renderer,
            Frame frame,
            View view,
            SceneStyle style,
            String title,
            String moment) {
        Shot shot = Shot.of(view, SIZE, SIZE, title);
        Camera camera = shot.camera(SceneBounds.of(body));
        BufferedImage picture = gl.picture(renderer, frame, camera, style, shot.width(), shot.height());
        if (Annotations.canWrite()) {
            Annotations annotations = Annotations.on(style.background() == Background.LIGHT)
                    .withTitle(title)
                    .withMoment(moment);
            (style.field() == ColourField.NONE
                            ? annotations
                            : annotations.withScale(style.field().label(), style.scale()))
                    .draw(picture, camera);
        }
        String file = name + ".png";
        PngFile.write(folder.resolve(file), picture);
        return file;
    }

    @Override
    public void close() {
        if (own) {
            gl.close();
        }
    }
}
