package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;

/** Pictures of the access map in a report. */
class NeedlePicturesTest {
    private static final int SIDE = 240;
    /** Of a channel above another, of 255. */
    private static final int DISTINCT = 30;

    private static final long LEAST_PIXELS = 50;

    @TempDir
    Path folder;

    private static AccessMap map(SceneFixture body) {
        MovingAnatomy anatomy = new MovingAnatomy(body.surfaces);
        anatomy.update(body.rest);
        double[] liver = body.surfaces.stream()
                .filter(s -> s.kind() == StructureKind.LIVER)
                .findFirst()
                .orElseThrow()
                .rest()
                .bounds();
        double[] middle = IntStream.range(0, 3)
                .mapToDouble(k -> 0.5 * (liver[k] + liver[3 + k]))
                .toArray();
        try (Workers workers = Workers.of(1)) {
            return AccessMap.of(
                    anatomy,
                    List.of(new BreathMoment(body.rest, RespiratoryPhase.PAUSE)),
                    new TargetLesion(middle, 20),
                    Needle.standard(),
                    NoGoZone.defaults(),
                    workers);
        }
    }

    /** Numbers of pixels as green as the colour for always free, and as blue as no colour of the map is. */
    private static long[] greenAndBlue(BufferedImage picture) {
        long[] counts = new long[2];
        for (int i = 0; i < SIDE * SIDE; i++) {
            Color seen = new Color(picture.getRGB(i % SIDE, i / SIDE));
            counts[0] += seen.getGreen() > seen.getRed() + DISTINCT ? 1 : 0;
            counts[1] += seen.getBlue() > seen.getGreen() + DISTINCT ? 1 : 0;
        }
        return counts;
    }

    @Test
    void greenMeansTheSameInTheReportAsInTheWindow() throws Exception {
        try (SceneFixture body = new SceneFixture();
                NeedlePictures pictures = NeedlePictures.using(body.offscreen, body.surfaces, SIDE)) {
            List<String> files = pictures.writeAccessMap(folder, map(body), "Access");
            assertThat(files).hasSize(3);
            BufferedImage right = ImageIO.read(folder.resolve(files.get(1)).toFile());
            Color chest = new Color(right.getRGB(SIDE / 2, SIDE / 3));
            assertThat(chest.getRed()).as("never free: skin").isGreaterThan(chest.getGreen());
            assertThat(chest.getGreen()).as("never free: skin").isGreaterThan(chest.getBlue());
            assertThat(greenAndBlue(right)[0]).as("always free: green").isGreaterThan(LEAST_PIXELS);
            assertThat(greenAndBlue(right)[1]).isZero();
        }
    }
}
