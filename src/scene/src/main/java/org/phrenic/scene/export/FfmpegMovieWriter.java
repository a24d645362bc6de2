package org.phrenic.scene.export;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.phrenic.file.AtomicFile;
import org.phrenic.file.Numbers;
import org.phrenic.file.OutputException;
import org.phrenic.file.UnfinishedFiles;

/**
 * Writes an H.264 movie with the {@code ffmpeg} program of this machine, which reads the pictures from a pipe. The file
 * is moved into place when complete. Odd widths and heights are padded by one pixel.
 *
 * @param program path of ffmpeg, as {@link #find} returns it
 */
public record FfmpegMovieWriter(Path program) implements MovieWriter {
    /** Timeout for ffmpeg after the last picture, s. */
    private static final long TIMEOUT_S = 300;

    /** Finds ffmpeg on the search path of this process. */
    public static Optional<Path> find() {
        return find(System.getenv("PATH"));
    }

    /** Finds ffmpeg in the folders of a search path. */
    static Optional<Path> find(String searchPath) {
        if (searchPath == null) {
            return Optional.empty();
        }
        return Arrays.stream(searchPath.split(File.pathSeparator))
                .filter(folder -> !folder.isBlank())
                .flatMap(FfmpegMovieWriter::programs)
                .filter(file -> Files.isRegularFile(file) && Files.isExecutable(file))
                .findFirst();
    }

    /** Names of the program in a folder; none if the entry of the search path is no path, such as a quoted one. */
    private static Stream<Path> programs(String folder) {
        try {
            return Stream.of(Path.of(folder, "ffmpeg"), Path.of(folder, "ffmpeg.exe"));
        } catch (InvalidPathException noPath) {
            return Stream.empty();
        }
    }

    @Override
    public void write(Path file, double framesPerS, Iterator<BufferedImage> frames) {
        Path work = workFolder(file, Path.of(System.getProperty("java.io.tmpdir")));
        try {
            Path made = work.resolve("movie.mp4");
            encode(file, made, work.resolve("log.txt"), framesPerS, frames);
            AtomicFile.write(file, out -> Files.copy(made, out));
        } catch (IOException e) {
            throw new OutputException(file + ": " + program + " could not be started: " + e.getMessage(), e);
        } finally {
            deleteFolder(work);
        }
    }

    /** Makes a folder in a temporary folder for what ffmpeg writes. */
    static Path workFolder(Path file, Path temporary) {
        try {
            Path work = Files.createTempDirectory(temporary, "phrenic-movie");
            UnfinishedFiles.add(work);
            return work;
        } catch (IOException e) {
            throw new OutputException(
                    file + ": found the temporary folder " + temporary + ", expected one that can be written", e);
        }
    }

    private void encode(Path file, Path made, Path log, double framesPerS, Iterator<BufferedImage> frames)
            throws IOException {
        BufferedImage first = frames.next();
        String options = Numbers.format(
                "-loglevel error -y -f rawvideo -pix_fmt bgr24 -video_size %dx%d -framerate %.6f -i - -an"
                        + " -c:v libx264 -preset medium -crf 18 -pix_fmt yuv420p -movflags +faststart",
                roundUpToEven(first.getWidth()), roundUpToEven(first.getHeight()), framesPerS);
        List<String> command = new ArrayList<>(List.of(options.split(" ")));
        command.add(0, program.toString());
        command.add(made.toString());
        Process process = new ProcessBuilder(command)
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

    /** Writes all pictures to the pipe; returns false if ffmpeg closed the pipe early. */
    private static boolean pipeFrames(Process process, BufferedImage first, Iterator<BufferedImage> frames) {
        int width = first.getWidth();
        int height = first.getHeight();
        BufferedImage even =
                new BufferedImage(roundUpToEven(width), roundUpToEven(height), BufferedImage.TYPE_3BYTE_BGR);
        Graphics2D g = even.createGraphics();
        byte[] bgr = ((DataBufferByte) even.getRaster().getDataBuffer()).getData();
        try (OutputStream pipe = new BufferedOutputStream(process.getOutputStream(), 1 << 16)) {
            for (BufferedImage picture = first; picture != null; picture = frames.hasNext() ? frames.next() : null) {
                g.drawImage(picture, 0, 0, null);
                // For odd sizes the last column, then the last row, once more; an even size copies nothing.
                g.copyArea(width - 1, 0, even.getWidth() - width, height, 1, 0);
                g.copyArea(0, height - 1, even.getWidth(), even.getHeight() - height, 0, 1);
                pipe.write(bgr);
            }
            return true;
        } catch (IOException broken) {
            return false;
        }
    }

    private static int roundUpToEven(int size) {
        return size + (size & 1);
    }

    private static String lastLine(Path log) throws IOException {
        String text = new String(Files.readAllBytes(log), StandardCharsets.UTF_8).strip();
        return text.isEmpty()
                ? "it said nothing"
                : text.substring(text.lastIndexOf('\n') + 1).strip();
    }

    private static void deleteFolder(Path work) {
        try (var files = Files.list(work)) {
            for (Path file : files.toList()) {
                Files.deleteIfExists(file);
            }
            Files.deleteIfExists(work);
            UnfinishedFiles.remove(work);
        } catch (IOException e) {
            System.getLogger(FfmpegMovieWriter.class.getName())
                    .log(System.Logger.Level.DEBUG, "temporary folder stays: " + work, e);
        }
    }
}
