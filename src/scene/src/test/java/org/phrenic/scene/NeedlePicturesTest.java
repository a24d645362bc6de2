package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.BreathMoment;
import org.phrenic.access.MovingAnatomy;
import org.phrenic.access.Needle;
import org.phrenic.access.NoGoZone;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.NeedleSnapshot;
import org.phrenic.access.path.AccessMap;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.breathing.RespiratoryPhase;
import org.phrenic.engine.parallel.Workers;
import org.phrenic.file.OutputException;

/** Pictures of the access map in a report. */
class NeedlePicturesTest {
    private static final int SIDE = 240;
    /** Of a channel above another, of 255. */
    private static final int DISTINCT = 30;

    private static final long LEAST_PIXELS = 50;
    /** More than the names of all buffers of a few renderers. */
    private static final int NAMES = 20_000;

    @TempDir
    Path folder;

    static AccessMap map(SceneFixture body) {
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
                    List.of(new BreathMoment(body.rest, RespiratoryPhase.PAUSE, 4)),
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

    static NeedleSnapshot moment(String name, SceneFixture body) {
        double[] tip = {0, 0, 0};
        return new NeedleSnapshot(
                name, body.rest, RespiratoryPhase.PAUSE, true, new double[] {-100, 0, 0}, tip, tip, 10);
    }

    /** Number of buffers that exist on the graphics card, of those with small names. */
    private static int buffers(SceneFixture body) {
        int[] count = {0};
        body.offscreen.run(gl -> {
            for (int name = 1; name < NAMES; name++) {
                count[0] += gl.glIsBuffer(name) ? 1 : 0;
            }
        });
        return count[0];
    }

    @Test
    void picturesThatCannotBeWrittenLeaveNothingOnTheGraphicsCard() throws Exception {
        Path file = Files.createFile(folder.resolve("a file"));
        try (SceneFixture body = new SceneFixture();
                NeedlePictures pictures = NeedlePictures.using(body.offscreen, new BodySurfaces(body.surfaces), SIDE)) {
            AccessMap map = map(body);
            NeedleSnapshot moment = moment("sample", body);
            List<String> written = new ArrayList<>();
            List<OutputException> unwritten = new ArrayList<>();
            pictures.writeAccessMap(folder, map, "Access", written::add, unwritten::add);
            pictures.writeNeedleViews(folder, moment, "Access", written::add, unwritten::add);
            assertThat(written).hasSize(6);
            assertThat(unwritten).isEmpty();
            int before = buffers(body);
            pictures.writeAccessMap(file, map, "Access", written::add, unwritten::add);
            pictures.writeNeedleViews(file, moment, "Access", written::add, unwritten::add);
            assertThat(written).hasSize(6);
            assertThat(unwritten).hasSize(6);
            assertThat(buffers(body)).isEqualTo(before);
        }
    }

    @Test
    void greenMeansTheSameInTheReportAsInTheWindow() throws Exception {
        try (SceneFixture body = new SceneFixture();
                NeedlePictures pictures = NeedlePictures.using(body.offscreen, new BodySurfaces(body.surfaces), SIDE)) {
            List<String> files = new ArrayList<>();
            pictures.writeAccessMap(folder, map(body), "Access", files::add, failure -> {});
            assertThat(files).hasSize(3);
            BufferedImage right = ImageIO.read(folder.resolve(files.get(1)).toFile());
            Color chest = new Color(right.getRGB(SIDE / 2, SIDE / 3));
            assertThat(chest.getRed()).as("never free: skin").isGreaterThan(chest.getGreen());
            assertThat(chest.getGreen()).as("never free: skin").isGreaterThan(chest.getBlue());
            assertThat(greenAndBlue(right)[0]).as("always free: green").isGreaterThan(LEAST_PIXELS);
            assertThat(greenAndBlue(right)[1]).isZero();
        }
    }

    @Test
    void whatIsNotInTheScanStandsInThePictures() throws Exception {
        try (SceneFixture body = new SceneFixture()) {
            AccessMap map = map(body);
            List<Integer> seen = new ArrayList<>();
            for (String notInScan : List.of("", "skin, lungs")) {
                List<String> files = new ArrayList<>();
                BodySurfaces shown = new BodySurfaces(body.surfaces, Set.of(), notInScan);
                try (NeedlePictures pictures = NeedlePictures.using(body.offscreen, shown, SIDE)) {
                    pictures.writeAccessMap(folder, map, "Access", files::add, failure -> {});
                }
                seen.add(Arrays.hashCode(
                        ImageIO.read(folder.resolve(files.get(0)).toFile()).getRGB(0, 0, SIDE, SIDE, null, 0, SIDE)));
            }
            assertThat(seen.get(1)).isNotEqualTo(seen.get(0));
        }
    }
}
