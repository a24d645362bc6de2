package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.mesh.TriangleMesh;
import org.phrenic.scenario.Scenario;
import org.phrenic.scene.annotate.Annotations;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.camera.PictureSettings;
import org.phrenic.scene.export.MovieWriter;
import org.phrenic.scene.export.PngFile;
import org.phrenic.scene.gl.GraphicsInfo;
import org.phrenic.scene.gl.NoGraphicsException;
import org.phrenic.scene.gl.OffscreenContext;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.SceneBounds;
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

    /** Simulates up to a time and writes a picture. */
    public void writePicture(Path file, double timeS, PictureSettings settings, SceneStyle style) {
        PngFile.write(file, render(player.advanceTo(timeS), settings, style));
    }

    /**
     * Simulates through the given times and writes a movie with one frame per time.
     *
     * @param single picture file for each frame index; empty for no picture files
     */
    public void writeMovie(
            Path file,
            MovieWriter kind,
            double framesPerS,
            double[] timesS,
            PictureSettings settings,
            SceneStyle style,
            Optional<IntFunction<Path>> single) {
        Stream<BufferedImage> frames = IntStream.range(0, timesS.length).mapToObj(i -> {
            BufferedImage picture = render(player.advanceTo(timesS[i]), settings, style);
            single.ifPresent(name -> PngFile.write(name.apply(i), picture));
            return picture;
        });
        kind.write(file, framesPerS, frames.iterator());
    }

    private BufferedImage render(Frame frame, PictureSettings settings, SceneStyle style) {
        Camera camera = settings.camera(SceneBounds.of(style.visible(surfaces())));
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
