package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import org.joml.Vector3d;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.TrunkSkin;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.file.OutputException;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.SurfaceMaterial;
import org.phrenic.scene.style.Transparency;
import org.phrenic.scene.surface.Markers;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Picture files of a rehearsal: the needle in the whole body, the needle in a section plane along it, and the access
 * map on the skin.
 */
public final class NeedlePictures implements AutoCloseable {
    /** Width and height of a picture, pixels. */
    public static final int SIZE = 720;

    private static final String NEEDLE = "needle";
    private static final String TARGET = "target";
    /** Radius of the drawn needle, larger than the real one for visibility. */
    private static final double DRAWN_RADIUS_MM = 1.2;

    static final Appearance NEEDLE_APPEARANCE = Appearance.of(0x1f4e79, 1);
    static final Appearance TARGET_APPEARANCE = Appearance.of(0xf2c500, 1);

    private final OffscreenContext gl;
    private final List<Surface> body;
    private final String notInScan;
    private final boolean ownsContext;
    private final int size;

    private NeedlePictures(OffscreenContext gl, BodySurfaces body, boolean ownsContext, int size) {
        this.gl = gl;
        this.body = body.surfaces();
        notInScan = body.notInScanSummary();
        this.ownsContext = ownsContext;
        this.size = size;
    }

    /**
     * Uses an open context. All calls must come from the thread of that context.
     *
     * @param size width and height of a picture, pixels
     */
    public static NeedlePictures using(OffscreenContext gl, BodySurfaces body, int size) {
        return new NeedlePictures(gl, body, false, size);
    }

    /**
     * Opens its own context, closed by {@link #close}.
     *
     * @throws NoGraphicsException if no OpenGL context is available; the message is one sentence
     */
    public static NeedlePictures open(BodySurfaces body) throws NoGraphicsException {
        return new NeedlePictures(OffscreenContext.headless(), body, true, SIZE);
    }

    /**
     * Writes pictures of the needle at one time: from the front, from the right, and in a section along the needle.
     *
     * @param written gets the name of each file once it is written
     * @param unwritten gets why a picture was not written
     */
    public void writeNeedleViews(
            Path folder,
            NeedleSnapshot view,
            String title,
            Consumer<String> written,
            Consumer<OutputException> unwritten) {
        List<Surface> all = new ArrayList<>(body);
        all.add(Markers.rod(NEEDLE, view.hub(), view.tip(), DRAWN_RADIUS_MM));
        all.add(Markers.ball(TARGET, view.target(), view.targetRadiusMm()));
        SceneStyle whole = style(all, (s, usual) -> switch (s.kind()) {
            case LIVER -> usual.withOpacity(0.38f);
            case DIAPHRAGM -> usual.withOpacity(0.16f);
            case LUNG -> usual.withOpacity(0.25f);
            case SKIN, PLEURA -> usual.withOpacity(0.10f);
            case RIB, COSTAL_CARTILAGE, STERNUM -> usual.withOpacity(0.55f);
            case VERTEBRA, DISC, ORGAN, VESSEL, MUSCLE, BONE, LESION, OTHER -> usual;
        });
        Set<StructureKind> opaque = Set.of(StructureKind.LUNG, StructureKind.LIVER);
        SceneStyle section = style(all, (s, usual) -> opaque.contains(s.kind()) ? usual.withOpacity(1) : usual)
                .withClip(Optional.of(planeAlong(view)));
        String time = Annotations.timestamp(view.frame().timeS(), view.label().label());
        Series series = new Series(folder, new Renderer(all, List.of()), view.frame(), time, written, unwritten);
        String cut = title + ", cut open along the needle";
        try {
            write(series, view.name() + "_anterior", AnatomicalView.ANTERIOR, whole, title);
            write(series, view.name() + "_right", AnatomicalView.RIGHT, whole, title);
            write(series, view.name() + "_section", AnatomicalView.INFERIOR, section, cut);
        } finally {
            gl.release(series.renderer);
        }
    }

    private static SceneStyle style(List<Surface> all, BiFunction<Surface, Appearance, Appearance> change) {
        return SceneStyle.atlas(all)
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withAppearances(all, change)
                .withAppearance(NEEDLE, NEEDLE_APPEARANCE)
                .withAppearance(TARGET, TARGET_APPEARANCE);
    }

    /** The plane through the needle that is closest to axial. The part below it is removed, as in an axial slice. */
    private static ClipPlane planeAlong(NeedleSnapshot view) {
        Vector3d tip = new Vector3d(view.tip());
        Vector3d d = new Vector3d(view.tip()).sub(new Vector3d(view.hub()));
        double horizontal = Math.hypot(d.x, d.y);
        Vector3d normal = horizontal > 0
                ? new Vector3d(d.z * d.x / horizontal, d.z * d.y / horizontal, -horizontal)
                : new Vector3d(0, -1, 0);
        normal.normalize();
        return new ClipPlane(normal.x, normal.y, normal.z, normal.dot(tip));
    }

    /**
     * Writes pictures of the access map on the skin at the first frame, from the front, the right and behind.
     *
     * @param written gets the name of each file once it is written
     * @param unwritten gets why a picture was not written
     */
    public void writeAccessMap(
            Path folder, AccessMap map, String title, Consumer<String> written, Consumer<OutputException> unwritten) {
        Surface skin = TrunkSkin.of(body).orElseThrow();
        Appearance opaque = SurfaceMaterial.of(StructureKind.SKIN).appearance().withOpacity(1);
        SceneStyle style = SceneStyle.atlas(body)
                .withAppearances(Map.of(skin.name(), opaque))
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withField(ColourField.ACCESS, skin.name(), AccessMapField.scale());
        Frame first = map.cycle().get(0).frame();
        Series series = new Series(folder, new Renderer(body, List.of()), first, "", written, unwritten);
        series.renderer.setField(skin.name(), map.freePercent());
        try {
            for (AnatomicalView view :
                    List.of(AnatomicalView.ANTERIOR, AnatomicalView.RIGHT, AnatomicalView.POSTERIOR)) {
                write(series, "access_" + view.label(), view, style, title);
            }
        } finally {
            gl.release(series.renderer);
        }
    }

    /** Data shared by the pictures of one time. */
    private record Series(
            Path folder,
            Renderer renderer,
            Frame frame,
            String timestamp,
            Consumer<String> written,
            Consumer<OutputException> unwritten) {}

    private void write(Series series, String name, AnatomicalView view, SceneStyle style, String title) {
        Camera camera = Camera.of(view, Surface.bounds(body));
        BufferedImage picture = gl.render(series.renderer, series.frame, camera, style, size, size);
        Annotations.of(style)
                .withTitle(title)
                .withTimestamp(series.timestamp)
                .withNotInScan(notInScan)
                .draw(picture, camera);
        String file = name + ".png";
        try {
            PngFile.write(series.folder.resolve(file), picture);
        } catch (OutputException failure) {
            series.unwritten.accept(failure);
            return;
        }
        series.written.accept(file);
    }

    @Override
    public void close() {
        if (ownsContext) {
            gl.close();
        }
    }
}
