package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.geometry.MeshRepair;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Surface;

/** Pictures of one surface in the colours of a distance at its vertices; nothing is simulated. */
public final class FieldPicture implements AutoCloseable {
    private static final String NAME = "surface";
    private static final int SAMPLES = 4;

    private final OffscreenGl gl;
    private final List<Surface> surfaces;
    private final Renderer renderer;

    private FieldPicture(OffscreenGl gl, TriangleMesh mesh, double[] distancesMm) {
        this.gl = gl;
        // What faces inward would be seen from behind.
        TriangleMesh outward = MeshRepair.orient(mesh).mesh();
        surfaces = List.of(
                new Surface(NAME, StructureKind.OTHER, 0, Side.MIDLINE, outward, Surface.Motion.STILL, new boolean[0]));
        renderer = new Renderer(surfaces, List.of());
        renderer.setField(NAME, DistanceField.narrowed(distancesMm));
    }

    /**
     * Finds something that draws.
     *
     * @param mesh LPS, mm
     * @param distancesMm one a vertex
     * @throws NoGraphicsException if nothing here draws, with one sentence
     */
    public static FieldPicture open(TriangleMesh mesh, double[] distancesMm) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return new FieldPicture(OffscreenGl.open(), mesh, distancesMm);
    }

    /** Writes a picture with the scale of its colours. */
    public void write(Path file, Shot shot, ColourScale scale) {
        PngFile.write(file, picture(shot, scale, SceneBounds.of(surfaces)));
    }

    /**
     * The same for a report, not yet written.
     *
     * @param box what is to be seen, so that pictures side by side show it alike: least x, y, z, then greatest, mm
     */
    public FigurePicture figure(
            String name, String alternative, String caption, Shot shot, ColourScale scale, double[] box) {
        return new FigurePicture(name, alternative, caption, picture(shot, scale, box));
    }

    private BufferedImage picture(Shot shot, ColourScale scale, double[] box) {
        SceneStyle style = SceneStyle.atlas(surfaces).withSamples(SAMPLES).withField(ColourField.DISTANCE, NAME, scale);
        return picture(gl, renderer, surfaces, style, shot, box);
    }

    /** A picture of surfaces as they lie, with letters and, of a quantity, its scale. */
    static BufferedImage picture(
            OffscreenGl gl, Renderer renderer, List<Surface> surfaces, SceneStyle style, Shot shot, double[] box) {
        Camera camera = shot.camera(box);
        BufferedImage picture = gl.picture(renderer, Frame.still(surfaces), camera, style, shot.width(), shot.height());
        if (shot.annotated() && Annotations.canWrite()) {
            Annotations plain =
                    Annotations.on(style.background() == Background.LIGHT).withTitle(shot.title());
            (style.field() == ColourField.NONE
                            ? plain
                            : plain.withScale(style.field().label(), style.scale()))
                    .draw(picture, camera);
        }
        return picture;
    }

    @Override
    public void close() {
        gl.release(renderer);
        gl.close();
    }
}
