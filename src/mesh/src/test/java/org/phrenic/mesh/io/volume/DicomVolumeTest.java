package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.ImageGrid;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * DICOM written by pydicom and highdicom has the labels and values, bit for bit, of twins in NIfTI, which other
 * programs wrote ({@code make_fixtures.py} beside the files). All lie obliquely.
 */
class DicomVolumeTest {
    /** Twins place voxels in single precision, 440 mm from the origin; contours are rounded to 1e-4 mm. */
    private static final double PLACE_MM = 1e-4;

    @TempDir
    private Path folder;

    private static Path resource(String name) {
        return VolumeSamples.resource(name);
    }

    static void assertIsTwin(LabelVolume volume, String twin) {
        LabelGrid grid = volume.grid();
        LabelGrid expected = LabelVolumeFiles.read(resource(twin)).grid();
        assertThat(new int[] {grid.columns(), grid.rows(), grid.slices()})
                .containsExactly(expected.columns(), expected.rows(), expected.slices());
        for (int v = 0; v < grid.voxelCount(); v++) {
            assertThat(grid.label(v)).as("voxel " + v).isEqualTo(expected.label(v));
        }
        double[] place = new double[3];
        double[] there = new double[3];
        for (int[] corner : new int[][] {{0, 0, 0}, {7, 0, 0}, {0, 6, 0}, {0, 0, 5}}) {
            grid.voxelToMm(corner[0], corner[1], corner[2], place);
            expected.voxelToMm(corner[0], corner[1], corner[2], there);
            assertThat(place).containsExactly(there, within(PLACE_MM));
        }
    }

    /**
     * Frames in any order, empty ones left out, shared or own planes, four transfer syntaxes, label maps, run lengths.
     */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "overlapping_seg.dcm",
                "turned_seg.dcm",
                "apart_seg.dcm",
                "implicit_seg.dcm",
                "deflated_seg.dcm",
                "big_endian_seg.dcm",
                "map_big_endian_seg.dcm",
                "map_seg.dcm",
                "map_rle_seg.dcm"
            })
    void segmentationsHaveTheLabelsOfTheirTwin(String name) {
        LabelVolume volume = LabelVolumeFiles.read(resource(name));
        assertIsTwin(volume, "labels_twin.nii.gz");
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver", 2, "cyst", 3, "Milz ä"));
        boolean overlap = !name.startsWith("map") && !name.startsWith("apart");
        assertThat(volume.notes().toString().contains("fewest voxels")).isEqualTo(overlap);
    }

    /** A segment labelled "Seg 1" in place of "liver", whose coded type says Liver. */
    @Test
    void aSegmentWithoutANameIsNamedByItsType() throws IOException {
        byte[] bytes = Files.readAllBytes(resource("map_seg.dcm"));
        String text = new String(bytes, StandardCharsets.ISO_8859_1);
        assertThat(text.split("liver ", -1)).as("the label stands there once").hasSize(2);
        byte[] numbered = text.replace("liver ", "Seg 1 ").getBytes(StandardCharsets.ISO_8859_1);
        LabelVolume volume = LabelVolumeFiles.read(Files.write(folder.resolve("numbered.dcm"), numbered));
        assertThat(volume.names()).isEqualTo(Map.of(1, "Liver", 2, "cyst", 3, "Milz ä"));
    }

    @Test
    void aFileWithoutEndingIsKnownByItsContent() throws IOException {
        Path bare = Files.copy(resource("apart_seg.dcm"), folder.resolve("1.2.826.0.1"));
        assertThat(LabelVolumeFiles.isVolume(bare)).isTrue();
        assertIsTwin(LabelVolumeFiles.read(bare), "labels_twin.nii.gz");
        assertThat(LabelVolumeFiles.isVolume(resource("make_fixtures.py"))).isFalse();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ct/contours.dcm", "ct/contours_big_endian.dcm"})
    void contoursAreFilledOnTheSeriesBesideThem(String name) {
        LabelVolume volume = LabelVolumeFiles.read(resource(name));
        assertIsTwin(volume, "regions_twin.nii.gz");
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver", 2, "cyst", 5, "Milz ä"));
    }

    /** OpenCV's outlines of masks with lines, dots, holes and frames within frames, as rt-utils writes them. */
    @Test
    void outlinesThroughPixelsGiveBackTheirMasks() {
        LabelVolume volume = LabelVolumeFiles.read(resource("ct/contours_pixels.dcm"));
        assertIsTwin(volume, "scattered_twin.nii.gz");
        assertThat(volume.notes())
                .containsExactly("contours through the centres of voxels were taken for outlines of masks, which hold"
                        + " these voxels: liver, cyst, Milz ä");
        assertThat(LabelVolumeFiles.read(resource("ct/contours.dcm")).notes())
                .as("outlines along the edges of pixels")
                .noneMatch(note -> note.contains("outlines of masks"));
    }

    /** Without their series, axial outlines through the centres of pixels of 0.98 mm, and along their edges. */
    @ParameterizedTest
    @ValueSource(strings = {"pixels_alone.dcm", "edges_alone.dcm"})
    void outlinesAloneGiveBackTheirMasks(String name) throws IOException {
        LabelGrid grid = LabelVolumeFiles.read(Files.copy(resource(name), folder.resolve(name)))
                .grid();
        LabelGrid expected =
                LabelVolumeFiles.read(resource("scattered_twin.nii.gz")).grid();
        assertThat(grid.spacing(0)).isCloseTo(0.9765625, within(1e-4));
        int[] box = grid.box(label -> label > 0);
        assertThat(box[3] - box[0]).isEqualTo(7);
        for (int v = 0; v < expected.voxelCount(); v++) {
            int row = v / 8 % 7 + box[1];
            int slice = v / 56 + box[2];
            assertThat(grid.label(v % 8 + box[0] + grid.columns() * (row + grid.rows() * slice)))
                    .as("voxel " + v)
                    .isEqualTo(expected.label(v));
        }
        double[] place = new double[3];
        grid.voxelToMm(box[0], box[1], box[2], place);
        assertThat(place).containsExactly(new double[] {-250, -241.7, 100}, within(1e-3));
    }

    private static byte[] half(String name) throws IOException {
        return Arrays.copyOf(Files.readAllBytes(resource(name)), 300);
    }

    /** What of the series cannot be read may be one of its slices. */
    @Test
    void theSeriesIsFoundBesideDamagedFilesButHasToBeWholeItself() throws IOException {
        Path contours = Files.copy(resource("ct/contours.dcm"), folder.resolve("contours.dcm"));
        Path images = Files.createDirectory(folder.resolve("images"));
        for (int slice = 0; slice < 6; slice++) {
            Files.copy(resource("ct/IM" + slice + ".dcm"), images.resolve("IM" + slice + ".dcm"));
        }
        byte[] half = half("ct/IM0.dcm");
        Files.write(Files.createDirectory(folder.resolve("backup")).resolve("IM0.dcm"), half);
        Files.write(folder.resolve("half.dcm"), half);
        assertIsTwin(LabelVolumeFiles.read(contours), "regions_twin.nii.gz");
        Files.write(images.resolve("IM0.dcm"), half);
        assertHasOwnGrid(
                LabelVolumeFiles.read(contours), images.resolve("IM0.dcm").toString());
    }

    /** A stray slice beside the contours, a half copied series and a damaged file of another one hide none. */
    @Test
    void readableSlicesThatHoldAllContoursAreUsed() throws IOException {
        Path contours = Files.copy(resource("ct/contours_sparse.dcm"), folder.resolve("contours.dcm"));
        Path images = Files.createDirectory(folder.resolve("images"));
        for (int slice = 0; slice < 6; slice++) {
            Files.copy(resource("ct/IM" + slice + ".dcm"), images.resolve("IM" + slice + ".dcm"));
        }
        Path stray = Files.copy(resource("ct/IM1.dcm"), folder.resolve("localizer.dcm"));
        Files.write(images.resolve("foreign.dcm"), half("ct/IM0.dcm"));
        Path backup = Files.createDirectory(folder.resolve("backup"));
        for (String slice : List.of("IM0.dcm", "IM1.dcm", "IM4.dcm")) {
            Files.copy(resource("ct/" + slice), backup.resolve(slice));
        }
        Files.write(backup.resolve("IM5.dcm"), half("ct/IM0.dcm"));
        LabelVolume volume = LabelVolumeFiles.read(contours);
        assertThat(volume.grid().counts()[1]).isEqualTo(6 * 5 * 5);
        assertThat(volume.notes())
                .anyMatch(note -> note.startsWith("a file beside the series of the contours was left out: ")
                        && note.contains("foreign.dcm"));
        Files.delete(stray);
        for (int slice = 0; slice < 6; slice++) {
            Files.write(images.resolve("IM" + slice + ".dcm"), half("ct/IM0.dcm"));
            Files.deleteIfExists(backup.resolve("IM" + slice + ".dcm"));
        }
        assertThat(LabelVolumeFiles.read(contours).notes())
                .as("no slice can be read")
                .anyMatch(note -> note.contains("is of no use") && note.contains("IM0.dcm"));
    }

    private static void assertHasOwnGrid(LabelVolume volume, String reason) {
        assertThat(volume.grid().spacing(0)).isCloseTo(1, within(1e-12));
        assertThat(volume.names().values()).contains("liver", "Milz ä");
        assertThat(volume.notes())
                .anyMatch(note -> note.startsWith("the series of the contours is of no use: they were filled in voxels"
                                + " of 1.0 mm in their own planes (")
                        && note.contains(reason));
    }

    @Test
    void besideASeriesWithoutAGridContoursHaveTheirOwn() throws IOException {
        Path contours = Files.copy(resource("ct/contours.dcm"), copyOfSeries().resolve("contours.dcm"));
        assertIsTwin(LabelVolumeFiles.read(contours), "regions_twin.nii.gz");
        Path second = folder.resolve("IM1.dcm");
        Path twice = Files.copy(second, folder.resolve("twice.dcm"));
        assertHasOwnGrid(LabelVolumeFiles.read(contours), "7 slices at 6 places");
        Files.delete(twice);
        Files.delete(second);
        assertHasOwnGrid(LabelVolumeFiles.read(contours), "unevenly apart or missing");
    }

    /** A scan of a part of the body, to which the contours refer as well, has the lower three of their slices. */
    @Test
    void besideASeriesThatHoldsFewContoursTheyHaveTheirOwnGrid() throws IOException {
        Path contours = Files.copy(resource("ct/contours.dcm"), folder.resolve("contours.dcm"));
        for (String slice : List.of("IM2.dcm", "IM1.dcm", "IM0.dcm")) {
            Files.copy(resource("ct/" + slice), folder.resolve(slice));
        }
        assertHasOwnGrid(LabelVolumeFiles.read(contours), "its slices hold ");
    }

    /** The other series has two slices of the same place, and comes first by its identifier. */
    @Test
    void ofTwoSeriesTheOneThatHoldsMostContoursIsTaken() throws IOException {
        Path contours =
                Files.copy(resource("contours_of_two.dcm"), copyOfSeries().resolve("contours.dcm"));
        for (String slice : List.of("IM2.dcm", "IM1.dcm")) {
            String text = Files.readString(resource("ct/" + slice), StandardCharsets.ISO_8859_1);
            Files.writeString(
                    folder.resolve("other-" + slice),
                    text.replace("8.498.1.2\0", "8.498.1.0\0"),
                    StandardCharsets.ISO_8859_1);
        }
        assertIsTwin(LabelVolumeFiles.read(contours), "regions_twin.nii.gz");
    }

    /** The liver is drawn on slices 0 to 4; without slice 0 in the folder its contour there has no voxels. */
    @Test
    void contoursBeyondTheSeriesAreLeftOutWithANote() throws IOException {
        for (String above : List.of("IM1.dcm", "IM0.dcm", "IM5.dcm", "IM4.dcm", "IM3.dcm")) {
            Files.copy(resource("ct/" + above), folder.resolve(above));
        }
        LabelVolume volume =
                LabelVolumeFiles.read(Files.copy(resource("ct/contours.dcm"), folder.resolve("contours.dcm")));
        assertThat(volume.grid().slices()).isEqualTo(5);
        assertThat(volume.notes()).anyMatch(note -> note.contains("contours of liver reach beyond the voxels"));
        assertThat(LabelVolumeFiles.read(resource("ct/contours.dcm")).notes())
                .noneMatch(note -> note.contains("beyond"));
    }

    /** The cyst is drawn around 2 x 1 pixels in two slices; here all corners of an outline lie in its first one. */
    @Test
    void aRegionTooSmallForAVoxelIsLeftOutWithANote() throws IOException {
        String file = Files.readString(resource("ct/contours.dcm"), StandardCharsets.ISO_8859_1);
        String[] outlines = {
            "-27.7748\\16.6342\\443.8683\\-25.8955\\17.3183\\443.8683\\-24.0161\\18.0023\\443.8683"
                    + "\\-24.5116\\19.3638\\444.2566\\-26.3910\\18.6798\\444.2566\\-28.2704\\17.9958\\444.2566",
            "-27.5093\\15.9046\\446.7661\\-25.6299\\16.5887\\446.7661\\-23.7505\\17.2727\\446.7661"
                    + "\\-24.2461\\18.6342\\447.1544\\-26.1254\\17.9502\\447.1544\\-28.0048\\17.2661\\447.1544"
        };
        for (String outline : outlines) {
            assertThat(file).contains(outline);
            String corner = outline.substring(0, outline.indexOf("\\-", 1));
            file = file.replace(outline, String.join("\\", Collections.nCopies(6, corner)));
        }
        for (int slice = 0; slice < 6; slice++) {
            Files.copy(resource("ct/IM" + slice + ".dcm"), folder.resolve("IM" + slice + ".dcm"));
        }
        Path contours = folder.resolve("contours.dcm");
        LabelVolume volume = LabelVolumeFiles.read(Files.writeString(contours, file, StandardCharsets.ISO_8859_1));
        assertThat(volume.names().values()).containsExactlyInAnyOrder("liver", "Milz ä");
        assertThat(volume.notes()).contains("contours that hold the middle of no voxel were left out: cyst");
    }

    /**
     * A block of 6 x 5 pixels drawn in slices 0, 2 and 4, after a contour across the slices: it fills slices 0 to 4. In
     * a folder without the series, its contours are 6 mm apart.
     */
    @Test
    void slicesBetweenContoursAreFilledAndAContourAcrossThemIsLeftOut() throws IOException {
        LabelVolume volume = LabelVolumeFiles.read(resource("ct/contours_sparse.dcm"));
        assertThat(volume.grid().counts()[1]).isEqualTo(6 * 5 * 5);
        assertThat(volume.notes())
                .anyMatch(note -> note.contains("the shape between their neighbours': liver"))
                .anyMatch(note ->
                        note.contains("of liver, contours that lie in none of the slices were left out, 1 in number"));
        LabelGrid alone = LabelVolumeFiles.read(
                        Files.copy(resource("ct/contours_sparse.dcm"), folder.resolve("alone.dcm")))
                .grid();
        assertThat(alone.spacing(2)).isCloseTo(6, within(1e-4));
        double drawn = 6 * 2 * 5 * 1.5 * 3 * 6;
        assertThat(alone.counts()[1] * alone.voxelVolume()).isCloseTo(drawn, within(0.05 * drawn));
    }

    /** The outline of slice 2 drawn 0.12 slices above it, and a closed contour of one point in the slice within it. */
    @Test
    void aStrayPointIsNoOutlineOfItsSlice() throws IOException {
        copyOfSeries();
        String file = Files.readString(resource("ct/contours_sparse.dcm"), StandardCharsets.ISO_8859_1);
        List<String> contours = Pattern.compile("(-?\\d+\\.\\d{4}\\\\){11,}-?\\d+\\.\\d{4}")
                .matcher(file)
                .results()
                .map(MatchResult::group)
                .toList();
        assertThat(contours).hasSize(4);
        String across = contours.get(0);
        file = file.replace(across, String.format("%-" + across.length() + "s", "-25.8776\\17.2694\\446.9602"));
        double[] shift = {0.0319, -0.0876, 0.3477};
        String[] numbers = contours.get(2).split("\\\\");
        Arrays.setAll(numbers, n -> String.format(Locale.ROOT, "%.4f", Double.parseDouble(numbers[n]) + shift[n % 3]));
        String shifted = String.join("\\", numbers);
        assertThat(shifted).hasSameSizeAs(contours.get(2));
        Path drawn = folder.resolve("contours.dcm");
        Files.writeString(drawn, file.replace(contours.get(2), shifted), StandardCharsets.ISO_8859_1);
        LabelVolume volume = LabelVolumeFiles.read(drawn);
        assertThat(volume.grid().counts()[1]).isEqualTo(6 * 5 * 5);
        assertThat(volume.notes()).noneMatch(note -> note.contains("nearer together"));
    }

    /**
     * In voxels of 1 mm: the region has the volume and the centre of the pixels that it was drawn around, within what
     * voxels of that size leave open along its outline.
     */
    @Test
    void contoursAloneAreFilledInTheirOwnPlanes() throws IOException {
        LabelVolume volume =
                LabelVolumeFiles.read(Files.copy(resource("contours_alone.dcm"), folder.resolve("alone.dcm")));
        LabelGrid grid = volume.grid();
        LabelGrid expected =
                LabelVolumeFiles.read(resource("regions_twin.nii.gz")).grid();
        double drawn = (6 * 5 * 5 - 2 * 3) * expected.voxelVolume();
        assertThat(grid.counts()[1] * grid.voxelVolume()).isCloseTo(drawn, within(0.05 * drawn));
        assertThat(grid.spacing(0)).isCloseTo(1, within(1e-12));
        assertThat(grid.spacing(2)).isCloseTo(3, within(1e-4));
        assertThat(volume.notes()).anyMatch(note -> note.contains("own planes"));
        double[] place = new double[3];
        double[] sum = new double[3];
        for (int v = 0; v < grid.voxelCount(); v++) {
            int row = v / grid.columns();
            grid.voxelToMm(v % grid.columns(), row % grid.rows(), row / grid.rows(), place);
            for (int axis = 0; axis < 3 && grid.label(v) == 1; axis++) {
                sum[axis] += place[axis] / grid.counts()[1];
            }
        }
        // Blocks of voxels 1 to 6, 1 to 5, 0 to 4 less 3 to 4, 3, 1 to 3: the centre stays at (3.5, 3, 2).
        expected.voxelToMm(3.5, 3, 2, place);
        assertThat(sum).containsExactly(place, within(0.2));
    }

    @Test
    void aSeriesIsAnImageSortedByPlaceAndRescaled() {
        ImageVolume image = ImageVolumeFiles.read(resource("ct"));
        ImageVolume twin = ImageVolumeFiles.read(resource("ct_twin.nii.gz"));
        ImageGrid expected = twin.grid();
        assertThat(image.grid().values()).containsExactly(expected.values());
        assertThat(image.grid().toMm()).containsExactly(expected.toMm(), within(PLACE_MM));
        assertThat(image.notes()).isEmpty();
        assertThat(twin.notes()).isEmpty();
    }

    /** The same 12 bits of the series as signed numbers: from 2048 on they are 4096 less. */
    @Test
    void signedPixelsHaveTheirSign() throws IOException {
        copyOfSeries();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                String slice = Files.readString(file, StandardCharsets.ISO_8859_1);
                String signed = slice.replace("(\0\3\1US\2\0\0\0", "(\0\3\1US\2\0\1\0")
                        .replace("(\0\3\1\2\0\0\0\0\0", "(\0\3\1\2\0\0\0\1\0");
                assertThat(signed).isNotEqualTo(slice);
                Files.writeString(file, signed, StandardCharsets.ISO_8859_1);
            }
        }
        float[] unsigned = ImageVolumeFiles.read(resource("ct")).grid().values();
        float[] values = ImageVolumeFiles.read(folder).grid().values();
        for (int v = 0; v < values.length; v++) {
            double stored = (unsigned[v] + 1024) / 1.5;
            assertThat(values[v]).isEqualTo((float) (1.5 * (stored < 2048 ? stored : stored - 4096) - 1024));
        }
    }

    /** Frames of one file in another order than their places, each with its own scale. */
    @Test
    void framesOfOneFileLieByTheirPlacesWithTheirOwnScale() {
        byte[][] frames = {
            DicomSamples.frame(6, 1, -1024), DicomSamples.frame(0, 2, 0), DicomSamples.frame(3, 1, 100),
        };
        byte[] file = DicomSamples.image(frames, 0, 1, 2, 3, 4, 5, -1024, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17);
        ImageGrid image = ImageVolumeFiles.read(VolumeSamples.write(folder, "enhanced.dcm", file))
                .grid();
        assertThat(new int[] {image.columns(), image.rows(), image.slices()}).containsExactly(3, 2, 3);
        assertThat(image.values())
                .containsExactly(
                        -2048, 14, 16, 18, 20, 22, 112, 113, 114, 115, 116, 117, -1024, -1023, -1022, -1021, -1020,
                        -1019);
        assertThat(image.toMm()).containsExactly(new double[] {2, 0, 0, 10, 0, 1.5, 0, 20, 0, 0, 3, 0}, within(1e-9));
    }

    /** The quaternion of the twin has no part that is 0. */
    @Test
    void anObliqueSeriesIsPlacedByTheQformOfItsTwinAlone() throws IOException {
        byte[] file;
        try (InputStream in = new GZIPInputStream(Files.newInputStream(resource("ct_twin.nii.gz")))) {
            file = in.readAllBytes();
        }
        ByteBuffer header = ByteBuffer.wrap(file).order(ByteOrder.LITTLE_ENDIAN);
        header.putShort(254, (short) 0);
        ImageGrid byQform = ImageVolumeFiles.read(VolumeSamples.write(folder, "qform.nii", file))
                .grid();
        double[] expected = ImageVolumeFiles.read(resource("ct")).grid().toMm();
        assertThat(byQform.toMm()).containsExactly(expected, within(PLACE_MM));
    }

    private Path copyOfSeries() throws IOException {
        try (Stream<Path> files = Files.list(resource("ct"))) {
            for (Path file : files.filter(f -> f.toString().contains("IM")).toList()) {
                Files.copy(file, folder.resolve(file.getFileName().toString()));
            }
        }
        return folder;
    }

    private void assertImageRefused(Path path, String part) {
        assertThatThrownBy(() -> ImageVolumeFiles.read(path))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(part)
                .hasMessageContaining("expected");
    }

    @Test
    void seriesWithGapsOrDoubleOrForeignSlicesAreRefused() throws IOException {
        Path series = copyOfSeries();
        assertThat(ImageVolumeFiles.read(series).grid().slices()).isEqualTo(6);
        Path second = series.resolve("IM1.dcm");
        byte[] slice = Files.readAllBytes(second);
        Files.write(series.resolve("twice.dcm"), slice);
        assertImageRefused(series, "7 slices at 6 places");
        Files.delete(series.resolve("twice.dcm"));
        Files.delete(second);
        assertImageRefused(series, "unevenly apart or missing (6.000 mm between those");
        assertImageRefused(series, "expected one every 3.000 mm");
        String text = new String(slice, StandardCharsets.ISO_8859_1);
        Files.write(second, text.replace("8.498.1.2\0", "8.498.1.9\0").getBytes(StandardCharsets.ISO_8859_1));
        assertImageRefused(series, "slices of 2 series");
        assertImageRefused(resource("ct/IM0.dcm"), "one slice");
        assertImageRefused(Files.createDirectory(folder.resolve("empty")), "no slices");
    }

    @Test
    void objectsOfOtherKindsAreRefused() {
        assertThatThrownBy(() -> LabelVolumeFiles.read(resource("ct/IM0.dcm")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("without labels, expected a segmentation or a structure set");
        assertThatThrownBy(() -> LabelVolumeFiles.read(VolumeSamples.write(folder, "text.dcm", new byte[300])))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("no 'DICM'");
    }
}
