package org.phrenic.scene.gl;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.jogamp.opengl.GL3;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.PictureDifference;
import org.phrenic.scene.SceneFixture;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.camera.Camera;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Overlay;
import org.phrenic.simulation.observe.Surface;

/** The renderer as its users see it: what it leaves behind, what it sends, and that what is asked for shows. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class RendererTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 120;

    private SceneFixture fixture;

    @BeforeAll
    void open() {
        fixture = new SceneFixture();
        fixture.offscreen.enableDebugging();
    }

    @AfterAll
    void close() {
        if (fixture != null) {
            fixture.close();
        }
    }

    private BufferedImage draw(Renderer renderer, SceneStyle style) {
        return fixture.offscreen.render(
                renderer, fixture.inspired, fixture.camera(AnatomicalView.ANTERIOR), style, WIDTH, HEIGHT);
    }

    private SceneStyle everything() {
        String diaphragm = fixture.name(StructureKind.DIAPHRAGM);
        String liver = fixture.name(StructureKind.LIVER);
        return fixture.style()
                .withRestWireframe(true)
                .withField(ColourField.STRAIN, diaphragm, ColourScale.diverging(20, "%"))
                .withOverlays(EnumSet.allOf(Overlay.Kind.class))
                .withClip(Optional.of(ClipPlane.sagittal(0)))
                .withHighlighted(liver)
                .withAppearance(
                        liver, fixture.style().appearance(liver).orElseThrow().withWireframe(true));
    }

    @Test
    void nothingThatCanBeAskedForRaisesAnErrorOfOpenGl() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        for (Transparency transparency : Transparency.values()) {
            for (int samples : new int[] {0, 1, 4, 1000}) {
                draw(renderer, everything().withTransparency(transparency).withSamples(samples));
                draw(renderer, fixture.style().withTransparency(transparency).withSamples(samples));
            }
        }
        fixture.offscreen.run(gl -> assertThat(gl.glGetError()).isEqualTo(GL3.GL_NO_ERROR));
        fixture.offscreen.release(renderer);
    }

    @Test
    void stateOfTheContextIsAsItWas() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        fixture.offscreen.run(gl -> {
            int[] name = new int[1];
            gl.glGenFramebuffers(1, name, 0);
            gl.glBindFramebuffer(GL3.GL_FRAMEBUFFER, name[0]);
            gl.glViewport(1, 2, 30, 40);
            renderer.draw(gl, fixture.rest, fixture.camera(AnatomicalView.LEFT), everything(), WIDTH, HEIGHT);
            renderer.readPixels(gl);
            assertThat(GraphicsInfo.number(gl, GL3.GL_DRAW_FRAMEBUFFER_BINDING)).isEqualTo(name[0]);
            assertThat(GraphicsInfo.number(gl, GL3.GL_READ_FRAMEBUFFER_BINDING)).isEqualTo(name[0]);
            assertThat(GraphicsInfo.number(gl, GL3.GL_VERTEX_ARRAY_BINDING))
                    .isEqualTo(gl.getContext().getDefaultVAO());
            int[] viewport = new int[4];
            gl.glGetIntegerv(GL3.GL_VIEWPORT, viewport, 0);
            assertThat(viewport).containsExactly(1, 2, 30, 40);
            gl.glDeleteFramebuffers(1, name, 0);
        });
        fixture.offscreen.release(renderer);
    }

    @Test
    void onlyWhatChangedIsSent() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        SceneStyle style = fixture.style();
        fixture.offscreen.render(renderer, fixture.rest, fixture.camera(AnatomicalView.LEFT), style, WIDTH, HEIGHT);
        fixture.offscreen.render(renderer, fixture.rest, fixture.camera(AnatomicalView.RIGHT), style, WIDTH, HEIGHT);
        assertThat(renderer.statistics().bytesUploaded()).as("the same frame").isZero();
        fixture.offscreen.render(renderer, fixture.inspired, fixture.camera(AnatomicalView.LEFT), style, WIDTH, HEIGHT);
        long vertices = fixture.surfaces.stream()
                .filter(s -> s.motion() == Surface.Motion.DEFORMING)
                .mapToLong(s -> s.rest().vertexCount())
                .sum();
        // Three coordinates and a packed normal, four bytes each.
        assertThat(renderer.statistics().bytesUploaded()).as("another frame").isEqualTo(16 * vertices);
        assertThat(renderer.statistics().drawCalls()).isBetween(50, 150);
        fixture.offscreen.release(renderer);
    }

    @Test
    void whatIsHiddenIsNotSentAndWhenShownStandsWhereItIs() {
        String liver = fixture.name(StructureKind.LIVER);
        SceneStyle hidden = fixture.style()
                .withAppearance(
                        liver, fixture.style().appearance(liver).orElseThrow().withVisible(false));
        SceneStyle shown = fixture.style().withField(ColourField.DISPLACEMENT, liver, ColourScale.diverging(20, "mm"));
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        fixture.offscreen.render(renderer, fixture.rest, camera, fixture.style(), WIDTH, HEIGHT);
        long all = sentWith(renderer, fixture.inspired, fixture.style());
        fixture.offscreen.render(renderer, fixture.rest, camera, shown, WIDTH, HEIGHT);
        long vertices = fixture.surfaces.stream()
                .filter(s -> s.name().equals(liver))
                .mapToLong(s -> s.rest().vertexCount())
                .sum();
        assertThat(sentWith(renderer, fixture.inspired, hidden)).isEqualTo(all - 16 * vertices);
        BufferedImage later = draw(renderer, shown);
        fixture.offscreen.release(renderer);
        Renderer fresh = new Renderer(fixture.surfaces, fixture.overlays);
        assertThat(PictureDifference.of(later, draw(fresh, shown)).largest()).isZero();
        fixture.offscreen.release(fresh);
    }

    private long sentWith(Renderer renderer, Frame frame, SceneStyle style) {
        fixture.offscreen.render(renderer, frame, fixture.camera(AnatomicalView.ANTERIOR), style, WIDTH, HEIGHT);
        return renderer.statistics().bytesUploaded();
    }

    @Test
    void nothingOfTheGraphicsCardIsKept() {
        for (int i = 0; i < 2; i++) {
            Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
            draw(renderer, everything().withTransparency(Transparency.values()[i]));
            assertThat(renderer.liveObjects()).isPositive();
            fixture.offscreen.release(renderer);
            assertThat(renderer.liveObjects())
                    .as("objects after dispose of renderer %d", i)
                    .isZero();
        }
    }

    @Test
    void fourteenPicturesTakeNoMoreThanAFew() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        fixture.offscreen.run(gl -> {
            int after = 0;
            for (int i = 0; i < 14; i++) {
                renderer.draw(
                        gl,
                        i % 2 == 0 ? fixture.rest : fixture.inspired,
                        fixture.camera(AnatomicalView.LEFT).orbit(i, 0),
                        i % 8 == 0 ? everything() : fixture.style(),
                        40 + i % 4,
                        30);
                if (i == 4) {
                    after = renderer.liveObjects();
                }
            }
            assertThat(renderer.liveObjects()).isEqualTo(after);
        });
        fixture.offscreen.release(renderer);
        assertThat(renderer.liveObjects()).isZero();
    }

    /** As a snapshot of a window on a card with little memory; the view goes on. */
    @Test
    void aSizeThatTheDriverRefusesLeavesNothingBehindAndTheNextPictureIsAsTheOneBefore() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        SceneStyle style = fixture.style().withSamples(0);
        draw(renderer, style);
        BufferedImage before = draw(renderer, style);
        int objects = renderer.liveObjects();
        fixture.offscreen.run(gl -> assertThatThrownBy(() -> renderer.draw(
                        gl, fixture.rest, fixture.camera(AnatomicalView.ANTERIOR), style, 1 << 20, HEIGHT))
                .isInstanceOf(RuntimeException.class));
        draw(renderer, style);
        assertThat(PictureDifference.of(before, draw(renderer, style)).mean()).isZero();
        assertThat(renderer.liveObjects()).isEqualTo(objects);
        fixture.offscreen.release(renderer);
    }

    @Test
    void translucencySortedForEachPixelIsDrawnAtTheResolutionThatIsAskedFor() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        SceneStyle style = fixture.style().withSamples(0).withTransparency(Transparency.PEELED);
        BufferedImage whole = draw(renderer, style);
        BufferedImage half = draw(renderer, style.withResolution(0.5));
        assertThat(PictureDifference.of(whole, half).mean()).isBetween(0.1, 4.0);
        fixture.offscreen.release(renderer);
    }

    @Test
    void aPictureInTilesIsThePictureInOnePiece() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        SceneStyle style = fixture.style().withSamples(0).withTransparency(Transparency.PEELED);
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        BufferedImage whole = fixture.offscreen.render(renderer, fixture.rest, camera, style, 300, 220);
        BufferedImage tiled = fixture.offscreen.render(renderer, fixture.rest, camera, style, 300, 220, 128);
        long other = 0;
        for (int y = 0; y < 220; y++) {
            for (int x = 0; x < 300; x++) {
                other += far(whole.getRGB(x, y), tiled.getRGB(x, y)) ? 1 : 0;
            }
        }
        // Rounding may put an edge into the neighbouring pixel.
        assertThat(other).isLessThan(300 * 220 / 100);
        fixture.offscreen.release(renderer);
    }

    private static boolean far(int a, int b) {
        return Math.abs((a & 0xff) - (b & 0xff)) > 12 || Math.abs((a >> 8 & 0xff) - (b >> 8 & 0xff)) > 12;
    }

    @Test
    void bothProjectionsShowTheSameBody() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        Camera camera = fixture.camera(AnatomicalView.ANTERIOR);
        BufferedImage perspective =
                fixture.offscreen.render(renderer, fixture.rest, camera, fixture.style(), WIDTH, HEIGHT);
        BufferedImage parallel = fixture.offscreen.render(
                renderer, fixture.rest, camera.withProjection(true), fixture.style(), WIDTH, HEIGHT);
        assertThat(PictureDifference.of(perspective, parallel).mean()).isBetween(0.1, 12.0);
        fixture.offscreen.release(renderer);
    }

    @Test
    void distanceIsShownInTheColoursOfTheScale() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        String liver = fixture.name(StructureKind.LIVER);
        int vertices = renderer.surfaces().stream()
                .filter(s -> s.name().equals(liver))
                .findFirst()
                .orElseThrow()
                .rest()
                .vertexCount();
        SceneStyle style = fixture.only(fixture.style(), StructureKind.LIVER)
                .withField(ColourField.DISTANCE, liver, ColourScale.sequential(10, "mm"));
        float[] far = new float[vertices];
        Arrays.fill(far, 10);
        renderer.setField(liver, new float[vertices]);
        int near = middle(draw(renderer, style));
        renderer.setField(liver, far);
        int away = middle(draw(renderer, style));
        // Viridis begins in dark violet and ends in yellow.
        assertThat(near & 0xff).as("blue at 0 mm").isGreaterThan(near >> 8 & 0xff);
        assertThat(away >> 8 & 0xff).as("green at 10 mm").isGreaterThan(2 * (away & 0xff));
        assertThatThrownBy(() -> renderer.setField(liver, new float[3]))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("found 3 values, expected one a vertex");
        fixture.offscreen.release(renderer);
    }

    @Test
    void aStructureThatIsPointedAtKeepsTheColoursThatTellAQuantity() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        String liver = fixture.name(StructureKind.LIVER);
        SceneStyle plain = fixture.only(fixture.style(), StructureKind.LIVER);
        SceneStyle map = plain.withField(ColourField.DISPLACEMENT, liver, ColourScale.sequential(10, "mm"));
        BufferedImage untouched = draw(renderer, map);
        assertThat(PictureDifference.of(untouched, draw(renderer, map.withHighlighted(liver)))
                        .mean())
                .as("a liver in the colours of its displacement")
                .isZero();
        assertThat(PictureDifference.of(draw(renderer, plain), draw(renderer, plain.withHighlighted(liver)))
                        .mean())
                .as("a liver in its own colour")
                .isPositive();
        fixture.offscreen.release(renderer);
    }

    @Test
    void attachmentsWithinTheBodyAreSeenThroughItsSkin() {
        Renderer renderer = new Renderer(fixture.surfaces, fixture.overlays);
        String skin = fixture.name(StructureKind.SKIN);
        SceneStyle opaque = fixture.only(fixture.style(), StructureKind.SKIN)
                .withAppearance(
                        skin, fixture.style().appearance(skin).orElseThrow().withOpacity(1));
        SceneStyle attachments = opaque.withOverlays(EnumSet.of(Overlay.Kind.ATTACHMENTS));
        assertThat(PictureDifference.of(draw(renderer, opaque), draw(renderer, attachments))
                        .mean())
                .isGreaterThan(5);
        fixture.offscreen.release(renderer);
    }

    /** The pixel at the middle of all that is not background, told by its place in the picture of the liver. */
    private static int middle(BufferedImage image) {
        long sumX = 0;
        long sumY = 0;
        long count = 0;
        int background = image.getRGB(0, 0);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                int rgb = image.getRGB(x, y);
                boolean coloured = Math.abs((rgb & 0xff) - (rgb >> 8 & 0xff)) > 30;
                if (coloured && rgb != background) {
                    sumX += x;
                    sumY += y;
                    count++;
                }
            }
        }
        return image.getRGB((int) (sumX / count), (int) (sumY / count));
    }
}
