package org.phrenic.scene.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.Iterator;
import java.util.NoSuchElementException;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.OutputException;

/** Pictures and movies as files: read back, they show what was given; when something fails, nothing is left. */
class PictureFilesTest {
    /** A colour in 256 of them may be off by this much a channel, of 255. */
    private static final int PALETTE_ERROR = 14;

    @TempDir
    Path folder;

    /** A bright bar on a gradient; the bar moves with the number. */
    private static BufferedImage picture(int number, int width, int height) {
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setPaint(new GradientPaint(0, 0, new Color(0x203040), 0, height, new Color(0xd0d8e0)));
        g.fillRect(0, 0, width, height);
        g.setColor(Color.RED);
        g.fillRect(10 * number, 10, 8, height - 20);
        g.dispose();
        return image;
    }

    private static Iterator<BufferedImage> pictures(int count, int width, int height) {
        return IntStream.range(0, count)
                .mapToObj(i -> picture(i, width, height))
                .iterator();
    }

    private Path[] left() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toArray(Path[]::new);
        }
    }

    /** Such as a full disc, which has nothing to do with ffmpeg. */
    @Test
    void aTemporaryFolderThatTakesNoMovieIsNamed() {
        Path missing = folder.resolve("missing");
        assertThatThrownBy(() -> FfmpegMovieWriter.workFolder(folder.resolve("breath.mp4"), missing))
                .isInstanceOf(OutputException.class)
                .hasMessage(folder.resolve("breath.mp4") + ": found the temporary folder " + missing
                        + ", expected one that can be written");
    }

    @Test
    void aPngIsThePictureAndOpaque() throws IOException {
        BufferedImage translucent = new BufferedImage(20, 10, BufferedImage.TYPE_INT_ARGB);
        translucent.setRGB(3, 4, 0xff123456);
        Path file = folder.resolve("deep/a.png");
        PngFile.write(file, translucent);
        BufferedImage read = ImageIO.read(file.toFile());
        assertThat(read.getColorModel().hasAlpha()).isFalse();
        assertThat(read.getRGB(3, 4)).isEqualTo(0xff123456);
        assertThat(read.getRGB(0, 0)).isEqualTo(0xffffffff);
    }

    @Test
    void aGifShowsEveryPictureForItsTimeAndBeginsAgain() throws IOException {
        Path file = folder.resolve("a.gif");
        new GifMovieWriter().write(file, 12, pictures(7, 97, 61));
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(in);
            assertThat(reader.getNumImages(true)).isEqualTo(7);
            int hundredths = 0;
            for (int i = 0; i < 7; i++) {
                IIOMetadataNode root =
                        (IIOMetadataNode) reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0");
                IIOMetadataNode control = (IIOMetadataNode)
                        root.getElementsByTagName("GraphicControlExtension").item(0);
                hundredths += Integer.parseInt(control.getAttribute("delayTime"));
                if (i == 0) {
                    IIOMetadataNode loop = (IIOMetadataNode)
                            root.getElementsByTagName("ApplicationExtension").item(0);
                    assertThat(loop.getAttribute("applicationID")).isEqualTo("NETSCAPE");
                    assertThat((byte[]) loop.getUserObject()).containsExactly(1, 0, 0);
                }
                assertAlike(reader.read(i), picture(i, 97, 61));
            }
            assertThat(hundredths).as("7 pictures at 12 a second last 0.58 s").isEqualTo(58);
        } finally {
            reader.dispose();
        }
    }

    private static void assertAlike(BufferedImage one, BufferedImage other) {
        for (int y = 0; y < other.getHeight(); y++) {
            for (int x = 0; x < other.getWidth(); x++) {
                for (int shift = 0; shift <= 16; shift += 8) {
                    int difference = (one.getRGB(x, y) >> shift & 0xff) - (other.getRGB(x, y) >> shift & 0xff);
                    assertThat(Math.abs(difference)).as("pixel %d %d", x, y).isLessThanOrEqualTo(PALETTE_ERROR);
                }
            }
        }
    }

    @Test
    void aPictureThatFailsLeavesNoMovie() throws IOException {
        Iterator<BufferedImage> failing = new Iterator<>() {
            private int given;

            @Override
            public boolean hasNext() {
                return true;
            }

            @Override
            public BufferedImage next() {
                if (given == 3) {
                    throw new NoSuchElementException("no picture");
                }
                return picture(given++, 32, 32);
            }
        };
        assertThatThrownBy(() -> new GifMovieWriter().write(folder.resolve("a.gif"), 10, failing))
                .isInstanceOf(NoSuchElementException.class);
        assertThat(left()).isEmpty();
    }

    @Test
    void aGifFasterThanViewersShowItIsRefused() {
        assertThatThrownBy(() -> new GifMovieWriter().write(folder.resolve("a.gif"), 60, pictures(1, 8, 8)))
                .hasMessageContaining("at most 50");
    }

    @Test
    void ffmpegMakesAMovieOfOddSizes() throws IOException {
        assumeThat(FfmpegMovieWriter.find()).as("ffmpeg on the path").isPresent();
        Path file = folder.resolve("a.mp4");
        new FfmpegMovieWriter(FfmpegMovieWriter.find().orElseThrow()).write(file, 10, pictures(5, 97, 61));
        assertThat(new String(Files.readAllBytes(file), 4, 4, StandardCharsets.US_ASCII))
                .as("first box of an MP4")
                .isEqualTo("ftyp");
        assertThat(left()).containsExactly(file);
    }

    private Path fakeFfmpeg(String script) throws IOException {
        Path bin = Files.createDirectories(folder.resolve("bin"));
        Path program = Files.writeString(bin.resolve("ffmpeg"), "#!/bin/sh\n" + script);
        assumeThat(program.getFileSystem().supportedFileAttributeViews()).contains("posix");
        Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
        return bin;
    }

    /** A program that writes its arguments and all that it is given into the file that it is to make. */
    @Test
    void ffmpegIsGivenEveryPictureInBlueGreenRedPaddedByItsLastRowAndColumn() throws IOException {
        Path bin = fakeFfmpeg("for last; do :; done\necho \"$@\" > \"$last\"\ncat >> \"$last\"\n");
        Path file = folder.resolve("a.mp4");
        new FfmpegMovieWriter(FfmpegMovieWriter.find(bin.toString()).orElseThrow())
                .write(file, 10, pictures(5, 97, 61));
        byte[] made = Files.readAllBytes(file);
        int end = 0;
        while (made[end] != '\n') {
            end++;
        }
        assertThat(new String(made, 0, end, StandardCharsets.US_ASCII))
                .contains("-pix_fmt bgr24 -video_size 98x62 -framerate 10.000000 -i -");
        ByteArrayOutputStream expected = new ByteArrayOutputStream();
        for (int n = 0; n < 5; n++) {
            BufferedImage picture = picture(n, 97, 61);
            assertThat(picture.getRGB(10 * n + 2, 20)).as("red").isEqualTo(0xffff0000);
            for (int y = 0; y < 62; y++) {
                for (int x = 0; x < 98; x++) {
                    int rgb = picture.getRGB(Math.min(x, 96), Math.min(y, 60));
                    expected.write(rgb);
                    expected.write(rgb >> 8);
                    expected.write(rgb >> 16);
                }
            }
        }
        assertThat(Arrays.copyOfRange(made, end + 1, made.length)).isEqualTo(expected.toByteArray());
    }

    @Test
    void ffmpegThatFailsIsToldWithItsLastLineAndLeavesNothing() throws IOException {
        Path bin = fakeFfmpeg("cat > /dev/null\necho 'first line' >&2\necho 'Unknown encoder libx264' >&2\nexit 3\n");
        Path ffmpeg = FfmpegMovieWriter.find("/nowhere:" + bin).orElseThrow();
        Path file = folder.resolve("made/a.mp4");
        assertThatThrownBy(() -> new FfmpegMovieWriter(ffmpeg).write(file, 10, pictures(5, 64, 64)))
                .isInstanceOf(OutputException.class)
                .hasMessageContaining("a.mp4: ffmpeg failed with exit code 3: Unknown encoder libx264")
                .hasMessageNotContaining("\n");
        assertThat(file).doesNotExist();
    }

    @Test
    void ffmpegThatStopsListeningOrMakesNothingIsToldToo() throws IOException {
        Path deaf = FfmpegMovieWriter.find(fakeFfmpeg("exit 1\n").toString()).orElseThrow();
        assertThatThrownBy(() -> new FfmpegMovieWriter(deaf).write(folder.resolve("a.mp4"), 10, pictures(50, 640, 480)))
                .hasMessageContaining("exit code 1: it said nothing");
        Path idle = FfmpegMovieWriter.find(fakeFfmpeg("cat > /dev/null\n").toString())
                .orElseThrow();
        assertThatThrownBy(() -> new FfmpegMovieWriter(idle).write(folder.resolve("a.mp4"), 10, pictures(2, 64, 64)))
                .hasMessageContaining("ffmpeg failed");
        assertThat(folder.resolve("a.mp4")).doesNotExist();
    }

    @Test
    void withoutFfmpegNoneIsFound() {
        assertThat(FfmpegMovieWriter.find(folder.toString())).isEmpty();
        assertThat(FfmpegMovieWriter.find("\0no path")).isEmpty();
        assertThat(FfmpegMovieWriter.find("")).isEmpty();
        assertThat(FfmpegMovieWriter.find((String) null)).isEmpty();
    }
}
