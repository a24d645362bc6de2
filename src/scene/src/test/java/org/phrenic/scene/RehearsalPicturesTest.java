package org.phrenic.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.access.BodySurfaces;
import org.phrenic.access.TargetLesion;
import org.phrenic.access.attempt.ProbeUse;
import org.phrenic.access.path.TargetAccess;
import org.phrenic.access.plan.Rehearsal;
import org.phrenic.access.plan.RehearsalPlan;

class RehearsalPicturesTest {
    private static final int SIDE = 64;

    @TempDir
    Path folder;

    private static Rehearsal rehearsal(SceneFixture body) {
        TargetLesion target = new TargetLesion(new double[3], 20);
        return new Rehearsal(
                RehearsalPlan.exercises().get(0),
                new BodySurfaces(body.surfaces),
                new TargetAccess(target, NeedlePicturesTest.map(body), List.of()),
                Optional.empty(),
                null,
                ProbeUse.NONE,
                List.of(NeedlePicturesTest.moment("placed", body), NeedlePicturesTest.moment("sample", body)),
                "");
    }

    /** Draws; the graphics are lost at the end of a call, counted from 0, or never. */
    private RehearsalPictures drawn(SceneFixture body, int lostAt) {
        RehearsalPictures pictures = new RehearsalPictures(rehearsal(body), folder);
        AtomicInteger calls = new AtomicInteger();
        try (NeedlePictures open = NeedlePictures.using(body.offscreen, new BodySurfaces(body.surfaces), SIDE)) {
            pictures.draw(what -> {
                what.accept(open);
                if (calls.getAndIncrement() == lostAt) {
                    throw new IllegalStateException("the device was lost");
                }
            });
        }
        return pictures;
    }

    @Test
    void theNeedleIsThatOfTheSamples() {
        try (SceneFixture body = new SceneFixture()) {
            RehearsalPictures all = drawn(body, -1);
            assertThat(all.missing()).isEmpty();
            assertThat(all.needle())
                    .extracting("source")
                    .containsExactly("sample_anterior.png", "sample_right.png", "sample_section.png");
            assertThat(all.map())
                    .extracting("source")
                    .containsExactly("access_anterior.png", "access_right.png", "access_posterior.png");
            assertThat(folder.resolve("placed_section.png")).exists();
        }
    }

    @Test
    void whatWasDrawnIsKeptAndTheFirstReasonIsTold() {
        try (SceneFixture body = new SceneFixture()) {
            RehearsalPictures some = drawn(body, 1);
            some.setMissing("no space left");
            assertThat(some.missing()).isEqualTo("the device was lost");
            assertThat(some.needle()).hasSize(3);
            assertThat(some.map()).isEmpty();
        }
    }
}
