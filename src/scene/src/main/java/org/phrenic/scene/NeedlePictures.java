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
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.scene.style.Transparency;
import org.phrenic.scene.surface.Markers;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Pictures of a rehearsal without a window: the needle in the body, whole and cut open in a plane along the needle, and
 * the access map on the skin.
 */
public final class NeedlePictures implements AutoCloseable {
    private static final int SIZE = 720;
    private static final int SAMPLES = 4;
    private static final String NEEDLE = "needle";
    private static final String TARGET = "target";
    /** Drawn thicker than it is, so that it is seen. */
    private static final double DRAWN_RADIUS_MM = 1.2;

    static final Appearance NEEDLE_APPEARANCE = Appearance.of(0x1f4e79, 1);
    static final Appearance TARGET_APPEARANCE = Appearance.of(0xf2c500, 1);

    private final OffscreenContext gl;
    private final List<Surface> body;
    private final boolean ownsContext;

    private NeedlePictures(OffscreenContext gl, List<Surface> body, boolean own) {
        this.gl = gl;
        this.body = body;
        this.ownsContext = own;
    }

    /** Draws with what draws already, on its thread. */
    public static NeedlePictures using(OffscreenContext gl, List<Surface> body) {
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
        return new NeedlePictures(OffscreenContext.open(), body, true);
    }

    /**
     * Writes the needle at one moment from the front, from the right and cut open along it.
     *
     * @return names of the files
     */
    public List<String> writeNeedleViews(Path folder, NeedleSnapshot view, String title) {
        List<Surface> all = new ArrayList<>(body);
        all.add(Markers.rod(NEEDLE, view.hub(), view.tip(), DRAWN_RADIUS_MM));
        all.add(Markers.ball(TARGET, view.target(), view.targetRadiusMm()));
        Renderer renderer = new Renderer(all, List.of());
        SceneStyle style = translucentStyle(all);
        List<String> names = new ArrayList<>();
        String moment =
                Annotations.timestamp(view.frame().timeS(), view.label().name().toLowerCase(Locale.ROOT));
        names.add(write(
                folder,
                view.name() + "_anterior",
                renderer,
                view.frame(),
                AnatomicalView.ANTERIOR,
                style,
                title,
                moment));
        names.add(write(
                folder, view.name() + "_right", renderer, view.frame(), AnatomicalView.RIGHT, style, title, moment));
        names.add(write(
                folder,
                view.name() + "_section",
                renderer,
                view.frame(),
                AnatomicalView.INFERIOR,
                sectionStyle(all, view),
                title + ", cut open along the needle",
                moment));
        gl.release(renderer);
        return names;
    }

    /** Bone, diaphragm and liver to be looked through, so that nothing hides needle and target. */
    private static SceneStyle translucentStyle(List<Surface> all) {
        Map<String, Appearance> looks = new LinkedHashMap<>();
        for (Surface s : all) {
            Appearance look = SurfaceMaterial.of(s.kind()).appearance();
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
        looks.put(NEEDLE, NEEDLE_APPEARANCE);
        looks.put(TARGET, TARGET_APPEARANCE);
        return SceneStyle.atlas(all).withAppearances(looks).withSamples(SAMPLES).withTransparency(Transparency.PEELED);
    }

    /**
     * A plane that holds the needle and is as level as it can be; what lies below is left out, so that it is seen as an
     * axial slice is.
     */
    private static SceneStyle sectionStyle(List<Surface> all, NeedleSnapshot view) {
        double[] d = {view.tip()[0] - view.hub()[0], view.tip()[1] - view.hub()[1], view.tip()[2] - view.hub()[2]};
        double flat = Math.sqrt(d[0] * d[0] + d[1] * d[1]);
        // At a right angle to the needle and to the level direction across it.
        double nx = flat > 0 ? -d[2] * d[0] / flat : 0;
        double ny = flat > 0 ? -d[2] * d[1] / flat : 1;
        double nz = flat;
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double[] p = view.tip();
        double offset = (nx * p[0] + ny * p[1] + nz * p[2]) / length;
        Map<String, Appearance> looks = new LinkedHashMap<>();
        for (Surface s : all) {
            Appearance look = SurfaceMaterial.of(s.kind()).appearance();
            looks.put(
                    s.name(),
                    switch (s.kind()) {
                        case LUNG, LIVER -> look.withOpacity(1);
                        default -> look;
                    });
        }
        looks.put(NEEDLE, NEEDLE_APPEARANCE);
        looks.put(TARGET, TARGET_APPEARANCE);
        return SceneStyle.atlas(all)
                .withAppearances(looks)
                .withSamples(SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withClip(Optional.of(new ClipPlane(-nx, -ny, -nz, -offset)));
    }

    /**
     * Writes the access map on the skin at the first moment, from the front, the right and behind.
     *
     * @return names of the files
     */
    public List<String> writeAccessMap(Path folder, AccessMap map, String title) {
        Renderer renderer = new Renderer(body, List.of());
        String skin = body.stream()
                .filter(s -> s.kind() == StructureKind.SKIN)
                .map(Surface::name)
                .findFirst()
                .orElseThrow();
        renderer.setField(skin, map.freePercent());
        ColourScale scale = ColourScale.sequential(100, ColourField.ACCESS.unit());
        SceneStyle style = SceneStyle.atlas(body)
                .withAppearances(Map.of(
                        skin,
                        SurfaceMaterial.of(StructureKind.SKIN).appearance().withOpacity(1)))
                .withSamples(SAMPLES)
                .withField(ColourField.ACCESS, skin, scale)
                .withOverlays(Set.of());
        Frame frame = map.cycle().get(0).frame();
        List<String> names = new ArrayList<>();
        for (AnatomicalView view : List.of(AnatomicalView.ANTERIOR, AnatomicalView.RIGHT, AnatomicalView.POSTERIOR)) {
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
            AnatomicalView view,
            SceneStyle style,
            String title,
            String moment) {
        PictureSettings shot = PictureSettings.of(view, SIZE, SIZE, title);
        Camera camera = shot.camera(SceneBounds.of(body));
        BufferedImage picture = gl.render(renderer, frame, camera, style, shot.width(), shot.height());
        if (Annotations.hasFonts()) {
            Annotations annotations = Annotations.forBackground(style.background() == SceneBackground.LIGHT)
                    .withTitle(title)
                    .withTimestamp(moment);
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
        if (ownsContext) {
            gl.close();
        }
    }
}
