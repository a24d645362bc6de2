package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.geometry.MeshRepair;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.simulation.Surface;

/** Pictures of several surfaces over each other, each with a look of its own; nothing is simulated. */
public final class LayersPicture implements AutoCloseable {
    private static final int SAMPLES = 4;

    /**
     * A surface and its look.
     *
     * @param mesh LPS, mm
     */
    public record Layer(TriangleMesh mesh, Look look) {}

    private final OffscreenGl gl;

    private LayersPicture(OffscreenGl gl) {
        this.gl = gl;
    }

    /**
     * Finds something that draws.
     *
     * @throws NoGraphicsException if nothing here draws, with one sentence
     */
    public static LayersPicture open() throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return new LayersPicture(OffscreenGl.open());
    }

    /** Draws layers; what is clear shows what lies behind it. */
    public FigurePicture draw(String name, String alternative, String caption, List<Layer> layers, Shot shot) {
        List<Surface> surfaces = new ArrayList<>();
        for (Layer layer : layers) {
            surfaces.add(new Surface(
                    "layer " + surfaces.size(),
                    StructureKind.OTHER,
                    0,
                    Side.MIDLINE,
                    MeshRepair.orient(layer.mesh()).mesh(),
                    Surface.Motion.STILL,
                    new boolean[0]));
        }
        SceneStyle style = SceneStyle.atlas(surfaces).withSamples(SAMPLES).withTransparency(Transparency.PEELED);
        for (int i = 0; i < layers.size(); i++) {
            style = style.withLook(surfaces.get(i).name(), layers.get(i).look());
        }
        Renderer renderer = new Renderer(surfaces, List.of());
        BufferedImage picture = FieldPicture.picture(gl, renderer, surfaces, style, shot, SceneBounds.of(surfaces));
        gl.release(renderer);
        return new FigurePicture(name, alternative, caption, picture);
    }

    @Override
    public void close() {
        gl.close();
    }
}
