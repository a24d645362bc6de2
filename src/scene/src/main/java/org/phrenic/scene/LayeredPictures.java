package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.FigureImage;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.observe.Surface;

/** Pictures of several surfaces over each other, each with a look of its own; nothing is simulated. */
public final class LayeredPictures implements AutoCloseable {
    private static final int SAMPLES = 4;

    /**
     * A surface and its look.
     *
     * @param mesh LPS, mm
     */
    public record Layer(TriangleMesh mesh, Appearance appearance) {}

    private final OffscreenContext gl;

    private LayeredPictures(OffscreenContext gl) {
        this.gl = gl;
    }

    /**
     * Finds something that draws.
     *
     * @throws NoGraphicsException if nothing here draws, with one sentence
     */
    public static LayeredPictures open() throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        return new LayeredPictures(OffscreenContext.open());
    }

    /** Draws layers; what is clear shows what lies behind it. */
    public FigureImage draw(String name, String alternative, String caption, List<Layer> layers, PictureSettings shot) {
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
            style = style.withAppearance(surfaces.get(i).name(), layers.get(i).appearance());
        }
        Renderer renderer = new Renderer(surfaces, List.of());
        BufferedImage picture = DistanceMapPictures.draw(gl, renderer, surfaces, style, shot, SceneBounds.of(surfaces));
        gl.release(renderer);
        return new FigureImage(name, alternative, caption, picture);
    }

    @Override
    public void close() {
        gl.close();
    }
}
