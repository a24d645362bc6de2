package org.phrenic.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.cli.report.ExitCode;
import org.phrenic.scenario.Assignment;
import org.phrenic.scenario.Scenario;
import org.phrenic.simulation.live.LiveRun;
import org.phrenic.simulation.live.LiveScene;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;

/** The line that a live run gives, pasted into a shell, gives its bits again. */
class LiveCommandTest {
    private static final long PATIENCE_S = 120;

    @TempDir
    Path folder;

    /** Words of a line as a shell takes them, for quotes as they are written here. */
    private static List<String> words(String line) {
        List<String> words = new ArrayList<>();
        StringBuilder word = new StringBuilder();
        boolean quoted = false;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '\'') {
                quoted = !quoted;
            } else if (c == '\\' && !quoted) {
                word.append(line.charAt(++i));
            } else if (c == ' ' && !quoted) {
                words.add(word.toString());
                word.setLength(0);
            } else {
                word.append(c);
            }
        }
        words.add(word.toString());
        return words;
    }

    private static void until(java.util.function.BooleanSupplier what) throws InterruptedException {
        for (long i = 0; i < PATIENCE_S * 200 && !what.getAsBoolean(); i++) {
            TimeUnit.MILLISECONDS.sleep(5);
        }
        assertThat(what.getAsBoolean()).isTrue();
    }

    @Test
    void theCommandOfALiveRunGivesItsHash() throws Exception {
        Path trace = Files.writeString(
                folder.resolve("it's a curve.csv"), "time_s,amplitude\n0,0\n1,1\n2,0\n3,1\n4,0\n5,1\n6,0\n7,1\n");
        Scenario scenario = Scenario.defaults()
                .with(
                        "resolution=low",
                        "lungs=embedded",
                        "sternum=kinematic",
                        "depth=1.2",
                        "rate_per_min=31",
                        "name=a b");
        CountDownLatch ready = new CountDownLatch(1);
        try (LiveRun run = new LiveRun(scenario, new Ready(ready))) {
            assertThat(ready.await(PATIENCE_S, TimeUnit.SECONDS)).isTrue();
            run.setSpeed(Double.POSITIVE_INFINITY);
            run.play();
            until(() -> run.status().step() > 100);
            run.change(List.of(Assignment.read("slider", "muscle_stiffness_n_per_m", "450.5")));
            until(() -> run.status().step() > 250);
            run.change(List.of(Assignment.read("button", "trace", trace.toString())));
            run.change(List.of(Assignment.read("field", "time_step_s", "7.5E-4")));
            until(() -> run.status().step() > 400);
            run.pause();
            until(() -> !run.status().playing());
            String line = run.command();
            assertThat(line)
                    .startsWith("phrenic run --set 'name=a b'")
                    .contains("--set depth=1.2", "--steps ", ":muscle_stiffness_n_per_m=450.5")
                    .contains("--change ")
                    .doesNotContain("duration_s", "liver");
            List<String> args = words(line);
            args.remove(0);
            args.add("--json");
            CommandLineRun pasted = CommandLineRun.of(args.toArray(new String[0]));
            assertThat(pasted.exitCode()).as(pasted.err()).isZero();
            Object hash = new Yaml(new SafeConstructor(new LoaderOptions()))
                    .<java.util.Map<String, Object>>load(pasted.out())
                    .get("state_sha256");
            assertThat(hash).isEqualTo(run.commandHash());
        }
    }

    @Test
    void aChangeThatCannotBeIsOneSentenceAndExitCodeTwo() {
        for (String change : List.of("5:depht=1", "x:depth=1", "5:resolution=low", "5:depth=99")) {
            CommandLineRun run = CommandLineRun.of("run", "--change", change, "--steps", "3");
            assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
            assertThat(run.err().strip())
                    .startsWith("phrenic: --change")
                    .contains(change)
                    .doesNotContain("\n");
        }
        assertThat(CommandLineRun.of("run", "--steps", "-1").err()).contains("found -1, expected 0");
    }

    private record Ready(CountDownLatch latch) implements LiveRun.Listener {
        @Override
        public void loading(String what, double share) {
            // Waited for as a whole.
        }

        @Override
        public void ready(LiveScene scene) {
            latch.countDown();
        }

        @Override
        public void failed(String sentence) {
            throw new AssertionError(sentence);
        }

        @Override
        public void diverged(String sentence) {
            throw new AssertionError(sentence);
        }

        @Override
        public void changed() {
            // Nothing shown here.
        }
    }
}
