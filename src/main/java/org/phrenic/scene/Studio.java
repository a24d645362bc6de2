package org.phrenic.scene;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.phrenic.geometry.TriangleMesh;
import org.phrenic.simulation.Frame;
import org.phrenic.simulation.Scenario;
import org.phrenic.simulation.SimulationRun;
import org.phrenic.simulation.Surface;

/** A scenario, simulated and drawn without a window: pictures and movies of it as files. Times must be asked for in order. */
public final class Studio implements AutoCloseable {
    private final OffscreenGl gl;
    private final ScenePlayer player;
    private final Renderer renderer;
    private final boolean letters = Annotations.canWrite();
    private Optional<DistanceField> distances = Optional.empty();

    private Studio(OffscreenGl gl, ScenePlayer player) {
        this.gl = gl;
        this.player = player;
        renderer = new Renderer(player.surfaces(), player.overlays());
    }

    /**
     * Finds something that draws, then puts the scenario together. Tells Java that there is no display: whatever the environment says, none is asked for.
     *
     * @throws NoGraphicsException if nothing here draws, with one sentence; nothing was simulated then
     */
    public static Studio open(Scenario scenario, SimulationRun.Progress progress) throws NoGraphicsException {
        System.setProperty("java.awt.headless", "true");
        OffscreenGl gl = OffscreenGl.open();
        try {
            return new Studio(gl, new ScenePlayer(scenario, progress));
        } catch (RuntimeException failed) {
            gl.close();
            throw failed;
        }
    }

    /** Sets what {@link ColourField#DISTANCE} is measured from. */
    public void measureFrom(TriangleMesh reference) {
        distances = Optional.of(new DistanceField(reference));
    }

    /** The surfaces of the scene. */
    public List<Surface> surfaces() {
        return player.surfaces();
    }

    /** Simulated time that all of the scenario takes, s. */
    public double totalS() {
        return player.totalS();
    }

    /** What draws. */
    public GraphicsInfo graphics() {
        return gl.info();
    }

    /** Whether letters can be written over pictures here. */
    public boolean canWriteLetters() {
        return letters;
    }

    /** Simulates to a time and writes a picture. */
    public void picture(Path file, double timeS, Shot shot, SceneStyle style) {
        PngFile.write(file, drawn(player.at(timeS), shot, style));
    }

    /**
     * Simulates through these times and writes them as a movie.
     *
     * @param single file of each frame as a picture of its own; empty for none
     */
    public void movie(
            Path file,
            Movie kind,
            double framesPerS,
            double[] timesS,
            Shot shot,
            SceneStyle style,
            Optional<IntFunction<Path>> single) {
        Iterator<BufferedImage> frames = IntStream.range(0, timesS.length)
                .mapToObj(i -> {
                    BufferedImage picture = drawn(player.at(timesS[i]), shot, style);
                    single.ifPresent(name -> PngFile.write(name.apply(i), picture));
                    return picture;
                })
                .iterator();
        kind.write(file, framesPerS, frames);
    }

    private BufferedImage drawn(Frame frame, Shot shot, SceneStyle style) {
        Camera camera = shot.camera(SceneBounds.of(visible(style)));
        if (style.field() == ColourField.DISTANCE) {
            distances.ifPresent(field -> field.colour(renderer, frame, style.fieldOn()));
        }
        BufferedImage picture = gl.picture(renderer, frame, camera, style, shot.width(), shot.height());
        if (shot.annotated() && letters) {
            annotations(frame, shot, style).draw(picture, camera);
        }
        return picture;
    }

    private List<Surface> visible(SceneStyle style) {
        return player.surfaces().stream()
                .filter(s -> style.look(s.name()).filter(Look::visible).isPresent())
                .toList();
    }

    private Annotations annotations(Frame frame, Shot shot, SceneStyle style) {
        Annotations annotations = Annotations.on(style.background() == Background.LIGHT)
                .withTitle(shot.title())
                .withMoment(Annotations.moment(frame.timeS(), player.phase()));
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
