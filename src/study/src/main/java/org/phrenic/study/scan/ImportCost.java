package org.phrenic.study.scan;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * What the import of a scan costs in a process of its own, from its start to its end.
 *
 * @param labels number of labels in the volume
 * @param structures number of surfaces that the import writes, completed ones included
 * @param firstLineS time until the first line of progress, s
 * @param clockS time by the clock, s
 * @param processorS processor time of all threads as last seen before the end, s; NaN where the system does not tell
 * @param memoryMb most memory of the process, MB; NaN where the system does not tell
 */
public record ImportCost(
        ScanSize size,
        int labels,
        int structures,
        double firstLineS,
        double clockS,
        double processorS,
        double memoryMb) {
    private static final int POLL_MS = 20;
    private static final double KB_IN_MB = 1024;

    /** The program that imports: how its process begins, up to {@code import}. */
    public record Program(List<String> command) {
        public Program {
            command = List.copyOf(command);
        }
    }

    /**
     * Measures one import.
     *
     * @param scan label volume, whose labels are those of TotalSegmentator
     * @param folder receives the volume and the body
     * @throws BadInputException with the program's last line if it does not import the volume
     */
    public static ImportCost of(Path scan, ScanSize size, Program program, Path folder) {
        LabelGrid grid = ResampledScan.of(LabelVolumeFiles.read(scan).grid(), size);
        int[] counts = grid.counts();
        int labels = (int)
                IntStream.range(1, counts.length).filter(l -> counts[l] > 0).count();
        Path volume = folder.resolve("scan.nii.gz");
        NiftiWriter.write(volume, grid);
        Path body = folder.resolve("body");
        List<String> command = Stream.concat(
                        program.command().stream(), Stream.of("import", volume.toString(), "--out", body.toString()))
                .toList();
        try {
            return new Watch(command).cost(size, labels, body);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the import was interrupted", e);
        }
    }

    /** A process while it runs. */
    private static final class Watch {
        private final long start = System.nanoTime();
        private final Process process;
        private double firstLineS = Double.NaN;

        Watch(List<String> command) throws IOException {
            process = new ProcessBuilder(command).redirectErrorStream(true).start();
            process.getOutputStream().close();
        }

        private double elapsed() {
            return 1e-9 * (System.nanoTime() - start);
        }

        private String output() {
            try (InputStream in = process.getInputStream()) {
                int first = in.read();
                firstLineS = elapsed();
                return first < 0 ? "" : (char) first + new String(in.readAllBytes(), StandardCharsets.UTF_8);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        ImportCost cost(ScanSize size, int labels, Path body) throws IOException, InterruptedException {
            CompletableFuture<String> output = CompletableFuture.supplyAsync(this::output);
            double processor = Double.NaN;
            double memory = Double.NaN;
            double end;
            boolean running;
            do {
                processor = process.info()
                        .totalCpuDuration()
                        .map(Duration::toMillis)
                        .map(ms -> 1e-3 * ms)
                        .orElse(processor);
                double most = memoryMb(process.pid());
                memory = Double.isNaN(most) ? memory : most;
                running = !process.waitFor(POLL_MS, TimeUnit.MILLISECONDS);
                end = elapsed();
            } while (running);
            String text = output.join();
            if (process.exitValue() != 0) {
                throw new BadInputException("the import of " + size + " voxels ended with exit code "
                        + process.exitValue() + ": " + lastLine(text));
            }
            try (Stream<Path> files = Files.list(body)) {
                int structures =
                        (int) files.filter(f -> f.toString().endsWith(".vtp")).count();
                return new ImportCost(size, labels, structures, firstLineS, end, processor, memory);
            }
        }

        private static String lastLine(String text) {
            return text.lines()
                    .filter(line -> !line.isBlank())
                    .reduce((before, line) -> line)
                    .orElse("it said nothing");
        }

        /** The most resident memory of a process so far, by Linux; NaN elsewhere and once it has ended. */
        private static double memoryMb(long process) {
            try {
                return Files.readAllLines(Path.of("/proc/" + process + "/status")).stream()
                        .filter(line -> line.startsWith("VmHWM:"))
                        .mapToDouble(line -> Double.parseDouble(line.replaceAll("\\D", "")) / KB_IN_MB)
                        .findFirst()
                        .orElse(Double.NaN);
            } catch (IOException | UncheckedIOException e) {
                return Double.NaN;
            }
        }
    }
}
