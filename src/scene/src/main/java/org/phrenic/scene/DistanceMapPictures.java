package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Pictures of one surface in the colours of a distance at its vertices; nothing is simulated. */
public final class DistanceMapPictures implements AutoCloseable {
    private static final String NAME = "surface";
    private static final int SAMPLES = 4;

    private final OffscreenContext gl;
    private final List<Surface> surfaces;
    private final Renderer renderer;

    private DistanceMapPictures(OffscreenContext gl, TriangleMesh mesh, double[] distancesMm) {
        this.gl = gl;
        // What faces inward would be seen from behind.
        TriangleMesh outward = MeshRepair.orient(mesh).mesh();
        surfaces = List.of(
                new Surface(NAME, StructureKind.OTHER, 0, Side.MIDLINE, outward, Surface.Motion.STILL, new boolean[0]));
        renderer = new Renderer(surfaces, List.of());
        renderer.setField(NAME, DistanceField.toFloats(distancesMm));
    }

    /**
     * Finds something that draws.
     *
     * @param mesh LPS, mm
     * @param distancesMm one a vertex
     * @throws NoGraphicsException if nothing here draws, with one sentence
     */
    public static DistanceMapPictures open(TriangleMesh mesh, double[] distancesMm) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return new DistanceMapPictures(OffscreenContext.open(), mesh, distancesMm);
    }

    /** Writes a picture with the scale of its colours. */
    public void write(Path file, PictureSettings shot, ColourScale scale) {
        PngFile.write(file, draw(shot, scale, SceneBounds.of(surfaces)));
    }

    /**
     * The same for a report, not yet written.
     *
     * @param box what is to be seen, so that pictures side by side show it alike: least x, y, z, then greatest, mm
     */
    public FigureImage render(
            String name, String alternative, String caption, PictureSettings shot, ColourScale scale, double[] box) {
        return new FigureImage(name, alternative, caption, draw(shot, scale, box));
    }

    private BufferedImage draw(PictureSettings shot, ColourScale scale, double[] box) {
        SceneStyle style = SceneStyle.atlas(surfaces).withSamples(SAMPLES).withField(ColourField.DISTANCE, NAME, scale);
        return draw(gl, renderer, surfaces, style, shot, box);
    }

    /** A picture of surfaces as they lie, with letters and, of a quantity, its scale. */
    static BufferedImage draw(
            OffscreenContext gl,
            Renderer renderer,
            List<Surface> surfaces,
            SceneStyle style,
            PictureSettings shot,
            double[] box) {
        Camera camera = shot.camera(box);
        BufferedImage picture = gl.render(renderer, Frame.still(surfaces), camera, style, shot.width(), shot.height());
        if (shot.annotated() && Annotations.hasFonts()) {
            Annotations plain = Annotations.forBackground(style.background() == SceneBackground.LIGHT)
                    .withTitle(shot.title());
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
