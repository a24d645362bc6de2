package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
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
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.surface.SceneBounds;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * A scenario, simulated and drawn without a window: pictures and movies of it as files. Times must be asked for in
 * order.
 */
public final class ScenarioRenderer implements AutoCloseable {
    private final OffscreenContext gl;
    private final ScenePlayer player;
    private final Renderer renderer;
    private final boolean fontsAvailable = Annotations.hasFonts();
    private Optional<DistanceField> distances = Optional.empty();

    private ScenarioRenderer(OffscreenContext gl, ScenePlayer player) {
        this.gl = gl;
        this.player = player;
        renderer = new Renderer(player.surfaces(), player.overlays());
    }

    /**
     * Finds something that draws, then puts the scenario together. Tells Java that there is no display: whatever the
     * environment says, none is asked for.
     *
     * @throws NoGraphicsException if nothing here draws, with one sentence; nothing was simulated then
     */
    public static ScenarioRenderer open(Scenario scenario, SimulationRun.Progress progress) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        OffscreenContext gl = OffscreenContext.open();
        try {
            return new ScenarioRenderer(gl, new ScenePlayer(scenario, progress));
        } catch (RuntimeException failed) {
            gl.close();
            throw failed;
        }
    }

    /** Sets what {@link ColourField#DISTANCE} is measured from. */
    public void setDistanceReference(TriangleMesh reference) {
        distances = Optional.of(new DistanceField(reference));
    }

    /** The surfaces of the scene. */
    public List<Surface> surfaces() {
        return player.surfaces();
    }

    /** Simulated time that all of the scenario takes, s. */
    public double durationS() {
        return player.durationS();
    }

    /** What draws. */
    public GraphicsInfo graphicsInfo() {
        return gl.info();
    }

    /** Whether letters can be written over pictures here. */
    public boolean hasFonts() {
        return fontsAvailable;
    }

    /** Simulates to a time and writes a picture. */
    public void writePicture(Path file, double timeS, PictureSettings shot, SceneStyle style) {
        PngFile.write(file, render(player.advanceTo(timeS), shot, style));
    }

    /**
     * Simulates through these times and writes them as a movie.
     *
     * @param single file of each frame as a picture of its own; empty for none
     */
    public void writeMovie(
            Path file,
            MovieWriter kind,
            double framesPerS,
            double[] timesS,
            PictureSettings shot,
            SceneStyle style,
            Optional<IntFunction<Path>> single) {
        Iterator<BufferedImage> frames = IntStream.range(0, timesS.length)
                .mapToObj(i -> {
                    BufferedImage picture = render(player.advanceTo(timesS[i]), shot, style);
                    single.ifPresent(name -> PngFile.write(name.apply(i), picture));
                    return picture;
                })
                .iterator();
        kind.write(file, framesPerS, frames);
    }

    private BufferedImage render(Frame frame, PictureSettings shot, SceneStyle style) {
        Camera camera = shot.camera(SceneBounds.of(visible(style)));
        if (style.field() == ColourField.DISTANCE) {
            distances.ifPresent(field -> field.upload(renderer, frame, style.fieldStructure()));
        }
        BufferedImage picture = gl.render(renderer, frame, camera, style, shot.width(), shot.height());
        if (shot.annotated() && fontsAvailable) {
            annotations(frame, shot, style).draw(picture, camera);
        }
        return picture;
    }

    private List<Surface> visible(SceneStyle style) {
        return player.surfaces().stream()
                .filter(s ->
                        style.appearance(s.name()).filter(Appearance::visible).isPresent())
                .toList();
    }

    private Annotations annotations(Frame frame, PictureSettings shot, SceneStyle style) {
        Annotations annotations = Annotations.forBackground(style.background() == SceneBackground.LIGHT)
                .withTitle(shot.title())
                .withTimestamp(Annotations.timestamp(frame.timeS(), player.phase()));
        return style.field() == ColourField.NONE
                ? annotations
                : annotations.withScale(style.field().label(), style.scale());
    }

    @Override
    public void close() {
        player.close();
        gl.close();
    }
}
