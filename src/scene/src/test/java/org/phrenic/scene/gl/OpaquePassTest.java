package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.PictureDifference;
import org.phrenic.scene.SceneFixture;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.Appearance;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.simulation.observe.Frame;

/** Pictures over what is kept of still surfaces are those in which all is drawn anew. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class OpaquePassTest {
    private static final int WIDTH = 240;
    private static final int HEIGHT = 180;

    private SceneFixture fixture;
    private Renderer keeping;
    private Renderer anewEachTime;

    @BeforeAll
    void open() {
        fixture = new SceneFixture();
        fixture.offscreen.enableDebugging();
        keeping = new Renderer(fixture.surfaces, fixture.overlays);
        anewEachTime = new Renderer(fixture.surfaces, fixture.overlays);
        for (Renderer renderer : new Renderer[] {keeping, anewEachTime}) {
            draw(renderer, fixture.rest, fixture.camera(AnatomicalView.ANTERIOR), style().withResolution(0.5));
            renderer.awaitCoarse();
        }
    }

    @AfterAll
    void close() {
        if (fixture != null) {
            fixture.offscreen.release(keeping);
            fixture.offscreen.release(anewEachTime);
            fixture.close();
        }
    }

    private BufferedImage draw(Renderer renderer, Frame frame, Camera camera, SceneStyle style) {
        return fixture.offscreen.render(renderer, frame, camera, style, WIDTH, HEIGHT);
    }

    private BufferedImage drawnAnew(Frame frame, Camera camera, SceneStyle style) {
        // The first picture of a view is drawn whole.
        draw(anewEachTime, frame, camera.orbit(90, 0), style);
        return draw(anewEachTime, frame, camera, style);
    }

    private void sameAsDrawnAnew(String what, Frame frame, Camera camera, SceneStyle style) {
        same(what, drawnAnew(frame, camera, style), draw(keeping, frame, camera, style));
    }

    private static void same(String what, BufferedImage anew, BufferedImage kept) {
        int greatest = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int a = anew.getRGB(x, y);
                int b = kept.getRGB(x, y);
                for (int shift = 0; shift < 24; shift += 8) {
                    greatest = Math.max(greatest, Math.abs((a >> shift & 0xff) - (b >> shift & 0xff)));
                }
            }
        }
        assertThat(greatest).as("greatest difference, levels of 255: %s", what).isLessThanOrEqualTo(1);
    }

    private SceneStyle style() {
        return fixture.style().withSamples(0);
    }

    private SceneStyle spine(SceneStyle style, UnaryOperator<Appearance> change) {
        return style.withAppearances(
                fixture.surfaces,
                (surface, look) -> surface.kind() == StructureKind.VERTEBRA ? change.apply(look) : look);
    }

    @Test
    void everyPictureOfARestingCameraIsThatWhichIsDrawnAnew() {
        for (AnatomicalView from : new AnatomicalView[] {AnatomicalView.ANTERIOR, AnatomicalView.POSTERIOR}) {
            for (double resolution : new double[] {1, 0.5}) {
                Camera camera = fixture.camera(from);
                SceneStyle style = style().withResolution(resolution);
                for (int i = 0; i < 3; i++) {
                    Frame frame = i % 2 == 0 ? fixture.rest : fixture.inspired;
                    sameAsDrawnAnew(from + " at " + resolution + ", picture " + i, frame, camera, style);
                }
            }
        }
    }

    @Test
    void whatIsKeptIsDroppedWhenItsPictureWouldDiffer() {
        Camera camera = fixture.camera(AnatomicalView.LEFT);
        SceneStyle style = style();
        String vertebra = fixture.name(StructureKind.VERTEBRA);
        for (SceneStyle other : new SceneStyle[] {
            style,
            style.withBackground(SceneBackground.DARK),
            spine(style, look -> look.withVisible(false)),
            spine(style, look -> look.withRgb(new float[] {0.2f, 0.5f, 0.9f})),
            spine(style, look -> look.withOpacity(0.5f)),
            spine(style, look -> look.withWireframe(true)),
            style.withHighlighted(vertebra),
            style.withClip(Optional.of(ClipPlane.sagittal(0))),
            style
        }) {
            draw(keeping, fixture.rest, camera, style);
            draw(keeping, fixture.rest, camera, style);
            BufferedImage anew = drawnAnew(fixture.inspired, camera, other);
            same("another style", anew, draw(keeping, fixture.inspired, camera, other));
            same("another style, second picture", anew, draw(keeping, fixture.inspired, camera, other));
        }
        sameAsDrawnAnew("a turned camera", fixture.inspired, camera.orbit(15, 0), style);
    }

    @Test
    void aStillSurfaceHasTheColoursOfItsValuesWhenTheyChange() {
        String vertebra = fixture.name(StructureKind.VERTEBRA);
        int vertices = fixture.surfaces.stream()
                .filter(s -> s.name().equals(vertebra))
                .mapToInt(s -> s.rest().vertexCount())
                .findFirst()
                .orElseThrow();
        Camera camera = fixture.camera(AnatomicalView.POSTERIOR);
        SceneStyle distance = style().withField(ColourField.DISTANCE, vertebra, ColourScale.sequential(10, "mm"));
        for (float mm : new float[] {0, 10, 5}) {
            float[] values = new float[vertices];
            Arrays.fill(values, mm);
            keeping.setField(vertebra, values);
            anewEachTime.setField(vertebra, values);
            sameAsDrawnAnew("values of " + mm + " mm", fixture.inspired, camera, distance);
        }
    }

    @Test
    void aRestingCameraDrawsFewerTriangles() {
        Camera camera = fixture.camera(AnatomicalView.SUPERIOR);
        draw(keeping, fixture.rest, camera, style());
        long all = keeping.statistics().triangles();
        draw(keeping, fixture.inspired, camera, style());
        draw(keeping, fixture.rest, camera, style());
        long still = fixture.surfaces.stream()
                .filter(s -> s.kind() == StructureKind.VERTEBRA || s.kind() == StructureKind.DISC)
                .mapToLong(s -> s.rest().triangles().length / 3)
                .sum();
        assertThat(all - keeping.statistics().triangles())
                .isGreaterThanOrEqualTo(still)
                .isPositive();
    }

    @Test
    void aCoarserPictureHasTheSizeAskedForAndShowsTheSame() {
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        BufferedImage whole = draw(keeping, fixture.inspired, camera, style());
        long triangles = keeping.statistics().triangles();
        for (double resolution : new double[] {0.85, 0.7, 0.5}) {
            BufferedImage coarse = draw(keeping, fixture.inspired, camera, style().withResolution(resolution));
            assertThat(coarse.getWidth()).isEqualTo(WIDTH);
            // Surfaces of few vertices keep all their triangles.
            assertThat(keeping.statistics().triangles()).isLessThan(triangles / 2);
            double mean = PictureDifference.of(whole, coarse).mean();
            assertThat(mean).as("mean difference at %s", resolution).isBetween(0.01, 6.0);
        }
    }

    @Test
    void edgesOfACoarsePictureAreSmooth() {
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        SceneStyle skin = style().withAppearances(
                        fixture.surfaces,
                        (surface, look) ->
                                surface.kind() == StructureKind.SKIN ? look.withOpacity(1) : look.withVisible(false));
        BufferedImage fine = draw(keeping, fixture.rest, camera, skin.withSamples(4));
        BufferedImage coarse = draw(keeping, fixture.rest, camera, skin.withResolution(0.5));
        double[] apart = IntStream.range(HEIGHT / 3, HEIGHT * 3 / 4)
                .mapToDouble(y -> outline(coarse, y) - outline(fine, y))
                .toArray();
        double mean = Arrays.stream(apart).average().orElseThrow();
        double spread = Math.sqrt(
                Arrays.stream(apart).map(d -> (d - mean) * (d - mean)).average().orElseThrow());
        // 0.73 without antialiasing, 0.52 with it.
        assertThat(spread)
                .as("spread of the outline about that of four samples, pixels")
                .isBetween(0.1, 0.62);
    }

    /** Where the first outline from the left crosses a row, pixels: halfway between background and skin. */
    private static double outline(BufferedImage picture, int y) {
        int background = green(picture, 1, y);
        int x = 2;
        while (background - green(picture, x, y) < 25) {
            x++;
        }
        double before = background - green(picture, x - 1, y);
        double after = background - green(picture, x, y);
        return x - 1 + (25 - before) / (after - before);
    }

    private static int green(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) >> 8 & 0xff;
    }
}
