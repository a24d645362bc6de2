package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import org.phrenic.anatomy.Side;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.mesh.edit.MeshRepair;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Pictures of surfaces without a simulation: coloured by distance, or several surfaces in one picture. */
public final class SurfacePictures implements AutoCloseable {

    private final OffscreenContext gl;

    /** @param mesh in LPS, mm */
    public record Layer(TriangleMesh mesh, Appearance appearance) {}

    /** @throws NoGraphicsException if no OpenGL context is available; the message is one sentence */
    public SurfacePictures() throws NoGraphicsException {
        gl = OffscreenContext.headless();
    }

    /**
     * Draws a surface coloured by a distance at each vertex.
     *
     * @param mesh in LPS, mm
     * @param distancesMm one distance per vertex, mm
     * @param bounds box to show: minimum x, y, z, then maximum x, y, z, mm
     */
    public BufferedImage distances(
            TriangleMesh mesh, double[] distancesMm, PictureSettings settings, ColourScale scale, double[] bounds) {
        Surface surface = surface("surface", mesh);
        SceneStyle style = SceneStyle.atlas(List.of(surface))
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withField(ColourField.DISTANCE, surface.name(), scale);
        Renderer renderer = new Renderer(List.of(surface), List.of());
        renderer.setField(surface.name(), DistanceField.toFloats(distancesMm));
        return picture(renderer, style, settings, bounds);
    }

    /** Draws several surfaces in one picture, each with its own appearance. */
    public BufferedImage layers(List<Layer> layers, PictureSettings settings) {
        List<Surface> surfaces = new ArrayList<>();
        layers.forEach(layer -> surfaces.add(surface("layer " + surfaces.size(), layer.mesh())));
        SceneStyle style = SceneStyle.atlas(surfaces)
                .withSamples(SceneStyle.SMOOTH_SAMPLES)
                .withTransparency(Transparency.PEELED)
                .withAppearances(
                        surfaces, (s, any) -> layers.get(surfaces.indexOf(s)).appearance());
        return picture(new Renderer(surfaces, List.of()), style, settings, Surface.bounds(surfaces));
    }

    /** The mesh as a surface with outward faces, because inward faces are not lit. */
    private static Surface surface(String name, TriangleMesh mesh) {
        TriangleMesh outward = MeshRepair.orient(mesh).mesh();
        return new Surface(name, StructureKind.OTHER, 0, Side.MIDLINE, outward, Surface.Motion.STILL, new boolean[0]);
    }

    private BufferedImage picture(Renderer renderer, SceneStyle style, PictureSettings settings, double[] bounds) {
        Camera camera = settings.camera(bounds);
        Frame frame = Frame.still(renderer.surfaces());
        BufferedImage picture = gl.render(renderer, frame, camera, style, settings.width(), settings.height());
        gl.release(renderer);
        if (settings.annotated()) {
            Annotations.of(style).withTitle(settings.title()).draw(picture, camera);
        }
        return picture;
    }

    @Override
    public void close() {
        gl.close();
    }
}
