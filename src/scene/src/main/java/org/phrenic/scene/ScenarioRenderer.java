package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/** Simulates a scenario and writes pictures and movies off screen. Times must be requested in ascending order. */
public final class ScenarioRenderer implements AutoCloseable {
    private final OffscreenContext gl;
    private final ScenePlayer player;
    private final Renderer renderer;
    private Optional<DistanceField> distances = Optional.empty();

    private ScenarioRenderer(OffscreenContext gl, ScenePlayer player) {
        this.gl = gl;
        this.player = player;
        renderer = new Renderer(player.surfaces(), player.overlays());
    }

    /**
     * @throws NoGraphicsException if no OpenGL context is available, before any simulation; the message is one sentence
     */
    public static ScenarioRenderer open(Scenario scenario, SimulationRun.Progress progress) throws NoGraphicsException {
        OffscreenContext gl = OffscreenContext.headless();
        try {
            return new ScenarioRenderer(gl, new ScenePlayer(scenario, progress));
        } catch (RuntimeException failed) {
            gl.close();
            throw failed;
        }
    }

    /** Sets the surface from which {@link ColourField#DISTANCE} is measured. */
    public void setDistanceReference(TriangleMesh reference) {
        distances = Optional.of(new DistanceField(reference));
    }

    public List<Surface> surfaces() {
        return player.surfaces();
    }

    /** Duration of the scenario, s. */
    public double durationS() {
        return player.durationS();
    }

    public GraphicsInfo graphicsInfo() {
        return gl.info();
    }

    /** A way of seeing the scene. */
    public Shot shot(PictureSettings settings, SceneStyle style) {
        return new Shot(timeS -> render(player.advanceTo(timeS), settings, style));
    }

    private BufferedImage render(Frame frame, PictureSettings settings, SceneStyle style) {
        Camera camera = settings.camera(Surface.bounds(style.visible(surfaces())));
        if (style.field() == ColourField.DISTANCE) {
            String structure = style.colouring().structure();
            distances.ifPresent(field -> field.upload(renderer, frame, structure));
        }
        BufferedImage picture = gl.render(renderer, frame, camera, style, settings.width(), settings.height());
        if (settings.annotated()) {
            String time = Annotations.timestamp(frame.timeS(), player.phase());
            Annotations.of(style)
                    .withTitle(settings.title())
                    .withTimestamp(time)
                    .withNotInScan(player.notInScan())
                    .draw(picture, camera);
        }
        return picture;
    }

    @Override
    public void close() {
        player.close();
        gl.close();
    }
}
