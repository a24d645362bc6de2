package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.scene.camera.AnatomicalView;
import org.phrenic.scene.gl.Renderer;
import org.phrenic.scene.style.ClipPlane;
import org.phrenic.scene.style.ColourField;
import org.phrenic.scene.style.ColourScale;
import org.phrenic.scene.style.SceneBackground;
import org.phrenic.scene.style.SceneStyle;
import org.phrenic.scene.style.Transparency;
import org.phrenic.simulation.observe.Frame;
import org.phrenic.simulation.observe.Surface;

/**
 * Four scenes look as they did. Stored pictures are renewed with {@code -Dphrenic.writeReferences=true}, to be looked
 * at before they are kept.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PictureRegressionTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final Path STORED = Path.of("src/scene/src/test/resources/org/phrenic/scene");

    private SceneFixture fixture;
    private Renderer renderer;

    @BeforeAll
    void open() {
        fixture = new SceneFixture();
        renderer = new Renderer(fixture.surfaces, fixture.overlays);
    }

    @AfterAll
    void close() {
        if (fixture != null) {
            fixture.offscreen.release(renderer);
            fixture.close();
        }
    }

    private BufferedImage draw(Frame frame, AnatomicalView view, SceneStyle style) {
        return fixture.offscreen.render(renderer, frame, fixture.camera(view), style, WIDTH, HEIGHT);
    }

    private Map<String, BufferedImage> scenes() {
        Map<String, BufferedImage> scenes = new LinkedHashMap<>();
        scenes.put("anterior-rest", draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style()));
        SceneStyle dark = fixture.style().withBackground(SceneBackground.DARK).withTransparency(Transparency.PEELED);
        scenes.put("left-inspired-dark", draw(fixture.inspired, AnatomicalView.LEFT, dark));
        SceneStyle coloured = fixture.only(fixture.style(), StructureKind.DIAPHRAGM)
                .withField(
                        ColourField.DISPLACEMENT,
                        fixture.name(StructureKind.DIAPHRAGM),
                        ColourScale.sequential(10, "mm"));
        scenes.put("superior-displacement", draw(fixture.inspired, AnatomicalView.SUPERIOR, coloured));
        SceneStyle cut = fixture.style().withClip(Optional.of(ClipPlane.coronal(middleY())));
        scenes.put("coronal-cut", draw(fixture.rest, AnatomicalView.ANTERIOR, cut));
        return scenes;
    }

    private double middleY() {
        double[] box = SceneFixture.bounds(fixture.surfaces);
        return (box[1] + box[4]) / 2;
    }

    private static BufferedImage stored(String name) throws IOException {
        try (InputStream in = PictureRegressionTest.class.getResourceAsStream(name + ".png")) {
            assertThat(in).as("stored picture of %s", name).isNotNull();
            return ImageIO.read(in);
        }
    }

    @Test
    void fourScenesLookAsStored() throws IOException {
        boolean write = Boolean.getBoolean("phrenic.writeReferences");
        for (Map.Entry<String, BufferedImage> scene : scenes().entrySet()) {
            if (write) {
                Files.createDirectories(STORED);
                ImageIO.write(
                        scene.getValue(),
                        "png",
                        STORED.resolve(scene.getKey() + ".png").toFile());
            } else {
                PictureDifference apart = PictureDifference.of(scene.getValue(), stored(scene.getKey()));
                assertThat(apart.isAlike()).as("%s: %s", scene.getKey(), apart).isTrue();
            }
        }
    }

    @Test
    void blackMirroredUpsideDownAndEmptyPicturesAreTold() {
        BufferedImage good = draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style());
        BufferedImage black = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        BufferedImage mirrored = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        BufferedImage turned = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                mirrored.setRGB(WIDTH - 1 - x, y, good.getRGB(x, y));
                turned.setRGB(x, HEIGHT - 1 - y, good.getRGB(x, y));
            }
        }
        BufferedImage empty = draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.only(fixture.style()));
        assertThat(PictureDifference.of(good, good).isAlike()).isTrue();
        assertThat(PictureDifference.of(good, black).isAlike()).isFalse();
        assertThat(PictureDifference.of(good, mirrored).isAlike()).isFalse();
        assertThat(PictureDifference.of(good, turned).isAlike()).isFalse();
        assertThat(PictureDifference.of(good, empty).isAlike()).isFalse();
    }

    @Test
    void aHiddenLiverAndAShiftedRibCageAreTold() {
        BufferedImage good = draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style());
        String liver = fixture.name(StructureKind.LIVER);
        SceneStyle without = fixture.style()
                .withAppearance(
                        liver, fixture.style().appearance(liver).orElseThrow().withVisible(false));
        assertThat(PictureDifference.of(good, draw(fixture.rest, AnatomicalView.ANTERIOR, without))
                        .isAlike())
                .isFalse();
        shiftRibs(6);
        BufferedImage shifted = draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style());
        shiftRibs(-6);
        assertThat(PictureDifference.of(good, shifted).isAlike()).isFalse();
    }

    /** Moves all ribs up, mm. */
    private void shiftRibs(float up) {
        for (int i = 0; i < fixture.surfaces.size(); i++) {
            if (fixture.surfaces.get(i).motion() == Surface.Motion.RIGID) {
                fixture.rest.pose(i)[11] += up;
            }
        }
        // A frame that was drawn is known by its nodes: one moves by nothing that is seen.
        fixture.rest.nodes()[0] += up * 1e-4f;
    }

    @Test
    void samplingOrNotShowsTheSame() {
        BufferedImage smooth = draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style());
        BufferedImage plain =
                draw(fixture.rest, AnatomicalView.ANTERIOR, fixture.style().withSamples(0));
        assertThat(PictureDifference.of(smooth, plain).isAlike()).isTrue();
    }
}
