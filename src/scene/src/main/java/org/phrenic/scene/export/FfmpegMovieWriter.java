package org.phrenic.scene.export;

import java.awt.image.BufferedImage;
import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.OutputException;

/**
 * An H.264 movie, made by the {@code ffmpeg} of this machine: pictures go to it through a pipe, and what it made is
 * moved into place when it is whole. Odd sizes get one more row or column of pixels.
 */
public final class FfmpegMovieWriter implements MovieWriter {
    /** Longest wait for ffmpeg once it has all pictures, s. */
    private static final long TIMEOUT_S = 300;

    private final Path program;

    /** @param program ffmpeg, as {@link #find} found it */
    public FfmpegMovieWriter(Path program) {
        this.program = program;
    }

    /** ffmpeg on the search path of this process. */
    public static Optional<Path> find() {
        return find(System.getenv("PATH"));
    }

    /** ffmpeg in the folders of a search path. */
    static Optional<Path> find(String searchPath) {
        if (searchPath == null) {
            return Optional.empty();
        }
        return Arrays.stream(searchPath.split(File.pathSeparator))
                .filter(folder -> !folder.isBlank())
                .flatMap(
                        folder -> List.of("ffmpeg", "ffmpeg.exe").stream().map(name -> new File(folder, name).toPath()))
                .filter(file -> Files.isRegularFile(file) && Files.isExecutable(file))
                .findFirst();
    }

    @Override
    public void write(Path file, double framesPerS, Iterator<BufferedImage> frames) {
        Path work = null;
        try {
            work = Files.createTempDirectory("phrenic-movie");
            Path made = work.resolve("movie.mp4");
            encode(file, made, work.resolve("log.txt"), framesPerS, frames);
            AtomicFile.write(file, out -> Files.copy(made, out));
        } catch (IOException e) {
            throw new OutputException(file + ": " + program + " could not be started: " + e.getMessage(), e);
        } finally {
            deleteFolder(work);
        }
    }

    private void encode(Path file, Path made, Path log, double framesPerS, Iterator<BufferedImage> frames)
            throws IOException {
        BufferedImage first = frames.next();
        Process process = new ProcessBuilder(
                        program.toString(),
                        "-loglevel",
                        "error",
                        "-y",
                        "-f",
                        "rawvideo",
                        "-pix_fmt",
                        "rgb24",
                        "-video_size",
                        roundUpToEven(first.getWidth()) + "x" + roundUpToEven(first.getHeight()),
                        "-framerate",
                        String.format(Locale.ROOT, "%.6f", framesPerS),
                        "-i",
                        "-",
                        "-an",
                        "-c:v",
                        "libx264",
                        "-preset",
                        "medium",
                        "-crf",
                        "18",
                        "-pix_fmt",
                        "yuv420p",
                        "-movflags",
                        "+faststart",
                        made.toString())
                .redirectOutput(log.resolveSibling("out.txt").toFile())
                .redirectError(log.toFile())
                .start();
        try {
            boolean taken = pipeFrames(process, first, frames);
            if (!process.waitFor(TIMEOUT_S, TimeUnit.SECONDS)) {
                throw new OutputException(file + ": ffmpeg did not end within " + TIMEOUT_S + " s", null);
            }
            if (process.exitValue() != 0 || !taken || !Files.isRegularFile(made) || Files.size(made) == 0) {
                throw new OutputException(
                        file + ": ffmpeg failed with exit code " + process.exitValue() + ": " + lastLine(log), null);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new OutputException(file + ": interrupted while ffmpeg was at work", e);
        } finally {
            process.destroyForcibly();
        }
    }

    /** Sends all pictures; false if ffmpeg stopped listening before. */
    private static boolean pipeFrames(Process process, BufferedImage first, Iterator<BufferedImage> frames) {
        int width = first.getWidth();
        int height = first.getHeight();
        byte[] bytes = new byte[3 * roundUpToEven(width) * roundUpToEven(height)];
        BufferedImage picture = first;
        boolean piped = false;
        try (OutputStream pipe = new BufferedOutputStream(process.getOutputStream(), 1 << 16)) {
            while (picture != null) {
                packRgb(picture, width, height, bytes);
                piped = writeTo(pipe, bytes);
                picture = piped && frames.hasNext() ? frames.next() : null;
            }
        } catch (IOException broken) {
            return false;
        }
        return piped;
    }

    /** Only a write to the pipe may fail without a word; what the pictures throw goes on. */
    private static boolean writeTo(OutputStream pipe, byte[] bytes) {
        try {
            pipe.write(bytes);
            return true;
        } catch (IOException broken) {
            return false;
        }
    }

    private static void packRgb(BufferedImage picture, int width, int height, byte[] bytes) {
        int[] row = new int[width];
        int o = 0;
        for (int y = 0; y < roundUpToEven(height); y++) {
            picture.getRGB(0, Math.min(y, height - 1), width, 1, row, 0, width);
            for (int x = 0; x < roundUpToEven(width); x++) {
                int pixel = row[Math.min(x, width - 1)];
                bytes[o++] = (byte) (pixel >> 16);
                bytes[o++] = (byte) (pixel >> 8);
                bytes[o++] = (byte) pixel;
            }
        }
    }

    private static int roundUpToEven(int size) {
        return size + (size & 1);
    }

    private static String lastLine(Path log) throws IOException {
        List<String> lines = new String(Files.readAllBytes(log), StandardCharsets.UTF_8)
                .lines()
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .toList();
        return lines.isEmpty() ? "it said nothing" : lines.get(lines.size() - 1);
    }

    private static void deleteFolder(Path work) {
        if (work == null) {
            return;
        }
        try (var files = Files.list(work)) {
            for (Path file : files.toList()) {
                Files.deleteIfExists(file);
            }
            Files.deleteIfExists(work);
        } catch (IOException e) {
            System.getLogger(FfmpegMovieWriter.class.getName())
                    .log(System.Logger.Level.DEBUG, "temporary folder stays: " + work, e);
        }
    }
}
