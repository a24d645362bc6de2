package org.phrenic.mesh.io.volume;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/** Headers of NRRD as Teem, ITK and earlier versions of 3D Slicer write them. */
class NrrdHeaderTest {
    private static final byte[] SHORTS = VolumeSamples.voxels(4, ByteOrder.LITTLE_ENDIAN, 1);

    @TempDir
    private Path folder;

    private LabelVolume read(String name, String header, byte[] data) {
        return LabelVolumeFiles.read(VolumeSamples.write(folder, name, VolumeSamples.join(header, data)));
    }

    private static void assertIsSample(LabelVolume volume) {
        LabelGrid grid = volume.grid();
        assertThat(grid.voxelCount()).isEqualTo(VolumeSamples.VOXELS);
        for (int v = 0; v < grid.voxelCount(); v++) {
            assertThat(grid.label(v)).isEqualTo(v);
        }
        double[] place = new double[3];
        grid.voxelToMm(1, 1, 1, place);
        assertThat(place).containsExactly(-8, -23, 34);
    }

    private static byte[] text(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    /** Teem reads fields of two words without the space between them, in any case of letters. */
    @Test
    void fieldsWithoutASpaceAreThoseWithOne() {
        String header = VolumeSamples.nrrd("short", "raw")
                .replace("space directions", "spacedirections")
                .replace("space origin", "SpaceOrigin");
        byte[] behind = VolumeSamples.join(text("two\nlines\n12345"), SHORTS);
        assertIsSample(read("raw.nrrd", header + "lineskip: 2\nbyteskip: 5\n\n", behind));
        VolumeSamples.write(folder, "voxels.raw", behind);
        assertIsSample(read("apart.nhdr", header + "lineskip: 2\nbyteskip: 5\nDataFile: voxels.raw\n", new byte[0]));
    }

    @Test
    void aFileOfVoxelsMayHaveANameThatBeginsAsAListOrHoldsAPercentSign() {
        for (String name : new String[] {"listed.raw", "LISTE.raw", "dose 95%.raw", "slice%03d.raw"}) {
            VolumeSamples.write(folder, name, SHORTS);
            String header = VolumeSamples.nrrd("short", "raw") + "data file: " + name + "\n\n";
            assertIsSample(read("apart.nhdr", header, new byte[0]));
            assertThat(read("apart.mhd", VolumeSamples.meta("MET_SHORT", false) + name + "\n", new byte[0])
                            .grid()
                            .voxelCount())
                    .isEqualTo(VolumeSamples.VOXELS);
        }
    }

    /** ITK counts back from the end of the unpacked data, whatever packs them; lines are skipped before. */
    @Test
    void voxelsThatEndTheirDataAreFoundInPackedDataAsInRaw() {
        byte[] ending = VolumeSamples.join(new byte[77], SHORTS);
        for (String encoding : new String[] {"raw", "gzip", "bzip2"}) {
            byte[] stored = encoding.equals("gzip")
                    ? VolumeSamples.gzip(ending)
                    : encoding.equals("bzip2") ? VolumeSamples.bzip2(ending) : ending;
            byte[] data = VolumeSamples.join(text("a line\n"), stored);
            String header = VolumeSamples.nrrd("short", encoding) + "line skip: 1\nbyte skip: -1\n";
            assertIsSample(read(encoding + ".nrrd", header + "\n", data));
            VolumeSamples.write(folder, encoding + ".bin", data);
            assertIsSample(read(encoding + ".nhdr", header + "data file: " + encoding + ".bin\n", new byte[0]));
        }
    }

    /** Metadata as SimpleITK writes them: a pair is no field, whatever its key. */
    @Test
    void pairsDoNotReplaceFields() {
        String header = VolumeSamples.nrrd("short", "raw") + "type:=CT\nencoding:=none\nsizes:=9 9 9\n\n";
        assertIsSample(read("pairs.nrrd", header, SHORTS));
    }

    @Test
    void tooFewBytesBeforeTheEndOfTheDataAreRefused() {
        String header = VolumeSamples.nrrd("short", "gzip") + "byte skip: -1\n\n";
        assertThatThrownBy(() -> read("short.nrrd", header, VolumeSamples.gzip(new byte[47])))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("found 47 bytes of voxels, expected 48 at the end of the data");
    }

    /** A header with the layers of segments as its first axis. */
    private static String layered(int layers, String segments) {
        return VolumeSamples.nrrd("uchar", "gzip")
                        .replace("dimension: 3", "dimension: 4")
                        .replace("sizes: 4 3 2", "sizes: " + layers + " 4 3 2")
                        .replace("(-2,0,0)", "none (-2,0,0)")
                        .replace("kinds: domain", "kinds: list domain")
                + segments + "\n";
    }

    /** Layers of 0 and 1 side by side: a voxel is in segment n if it is a multiple of n + 2. */
    private static byte[] layers(int count) {
        byte[] values = new byte[count * VolumeSamples.VOXELS];
        for (int n = 0; n < values.length; n++) {
            values[n] = (byte) (n / count % (n % count + 2) == 0 ? 1 : 0);
        }
        return VolumeSamples.gzip(values);
    }

    private static String segment(int number, String name) {
        return "Segment%d_ID:=s_%d\nSegment%d_Name:=%s\nSegment%d_Extent:=0 3 0 2 0 1\n"
                .formatted(number, number, number, name, number);
    }

    /** Versions of 3D Slicer up to 4.10 write a layer for each segment, and neither its number nor a value. */
    @Test
    void eachSegmentWithoutALayerOrAValueHasALayerOfItsOwn() {
        String segments = segment(0, "body") + segment(1, "liver") + segment(2, "cyst");
        LabelVolume volume = read("old.seg.nrrd", layered(3, segments), layers(3));
        assertThat(volume.names()).isEqualTo(Map.of(1, "body", 2, "liver", 3, "cyst"));
        LabelGrid grid = volume.grid();
        for (int v = 0; v < grid.voxelCount(); v++) {
            assertThat(grid.label(v)).isEqualTo(v % 4 == 0 ? 3 : v % 3 == 0 ? 2 : v % 2 == 0 ? 1 : 0);
        }
        LabelVolume one = LabelVolumeFiles.read(folder.resolve("old.seg.nrrd#1"));
        assertThat(one.names()).isEqualTo(Map.of(1, "liver"));
        assertThat(one.grid().counts()).containsExactly(16, 8);
    }

    @Test
    void aSegmentAloneWithoutAValueIsItsOnes() {
        LabelVolume volume = read("one.seg.nrrd", layered(1, segment(0, "liver")), layers(1));
        assertThat(volume.names()).isEqualTo(Map.of(1, "liver"));
        assertThat(volume.grid().counts()).containsExactly(12, 12);
    }

    /** Of a segmentation whose header lost a segment; of 3 layers, voxels 0, 4 ... 20 are in the last. */
    @Test
    void voxelsOfALayerThatBelongToNoSegmentAreTold() {
        String layer = "Segment%d_LabelValue:=1\nSegment%d_Layer:=%d\nSegment%d_Name:=%s\n";
        String segments = layer.formatted(0, 0, 0, 0, "body") + layer.formatted(1, 1, 1, 1, "liver");
        LabelVolume volume = read("lost.seg.nrrd", layered(3, segments), layers(3));
        assertThat(volume.grid().counts()).containsExactly(8, 8, 8);
        assertThat(volume.notes()).contains("voxels that belong to no segment were left out: 6 of value 1 in layer 2");
    }

    private static String mitk(String groups) {
        return "modality:=org.mitk.multilabel.segmentation\norg.mitk.multilabel.segmentation.labelgroups:=" + groups
                + "\n";
    }

    private static String label(String name, int value) {
        return "{\"color\":{\"type\":\"ColorProperty\",\"value\":[0.5,1.0,0.0]},\"locked\":true,\"name\":\"" + name
                + "\",\"opacity\":0.6,\"value\":" + value + ",\"visible\":true}";
    }

    /** A name with a quotation mark, and a group with a name and properties of its own. */
    @Test
    void labelsOfMitkHaveTheirNames() {
        String groups = "[{\"labels\":[" + label("Liver", 1) + "," + label("Milz \\\\\"ä\\\\\" \\\\u00e4", 7)
                + "],\"name\":\"first\",\"properties\":[{\"name\":\"none\",\"value\":3}]}]";
        LabelVolume volume = read("mitk.nrrd", VolumeSamples.nrrd("short", "raw") + mitk(groups) + "\n", SHORTS);
        assertIsSample(volume);
        assertThat(volume.names()).isEqualTo(Map.of(1, "Liver", 7, "Milz \"ä\" ä"));
    }

    @Test
    void damagedLabelsOfMitkAreNone() {
        for (String groups :
                new String[] {"]]}{", "[{\"labels\":[{\"name\":\"Liv", "[{\"labels\":[{\"value\":\\", "\""}) {
            LabelVolume volume = read("mitk.nrrd", VolumeSamples.nrrd("short", "raw") + mitk(groups) + "\n", SHORTS);
            assertIsSample(volume);
            assertThat(volume.names()).isEmpty();
        }
    }

    /** Groups are layers; a value that an earlier label has becomes the next free label. */
    @Test
    void groupsOfMitkAreLayers() {
        String groups =
                "[{\"labels\":[" + label("body", 1) + "]},{\"labels\":[" + label("liver", 1) + "]},{\"labels\":null}]";
        LabelVolume volume =
                read("mitk.nrrd", layered(3, mitk(groups)).replace("kinds: list", "kinds: vector"), layers(3));
        assertThat(volume.names()).isEqualTo(Map.of(1, "body", 2, "liver"));
        for (int v = 0; v < VolumeSamples.VOXELS; v++) {
            assertThat(volume.grid().label(v)).isEqualTo(v % 3 == 0 ? 2 : v % 2 == 0 ? 1 : 0);
        }
        assertThat(LabelVolumeFiles.read(folder.resolve("mitk.nrrd#1")).names()).isEqualTo(Map.of(1, "liver"));
    }

    /** One group over the phases of a breath, with as many labels as there are phases. */
    @Test
    void volumesOverTimeOfOneGroupOfMitkAreNoLayers() {
        String group =
                mitk("[{\"labels\":[" + label("body", 1) + "," + label("liver", 2) + "," + label("cyst", 3) + "]}]");
        assertThatThrownBy(() -> read("mitk.nrrd", layered(3, group), layers(3)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("3 volumes, expected the number of one");
        assertThat(LabelVolumeFiles.read(folder.resolve("mitk.nrrd#2")).names())
                .isEqualTo(Map.of(1, "body", 2, "liver", 3, "cyst"));
    }

    /** Two volumes with one segment are no layers of it, but such as phases of which one has to be named. */
    @Test
    void volumesOfAnotherNumberThanSegmentsAreNoLayers() {
        assertThatThrownBy(() -> read("phases.seg.nrrd", layered(2, segment(0, "liver")), layers(2)))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("2 volumes, expected the number of one");
    }

    /** ITK writes images of four dimensions in a space of four, which it does not name. */
    private static String fourDimensions(String columns, String time) {
        return VolumeSamples.nrrd("short", "raw")
                        .replace("space: right-anterior-superior", "space dimension: 4")
                        .replace("dimension: 3", "dimension: 4")
                        .replace("sizes: 4 3 2", "sizes: 4 3 2 2")
                        .replace("(-2,0,0) (0,3,0) (0,0,4)", columns + " (0,-3,0,0) (0,0,4,0) " + time)
                        .replace("domain domain domain", "domain domain domain domain")
                        .replace("(10,20,30)", "(-10,-20,30,0)")
                + "\n";
    }

    @Test
    void aSpaceOfFourDimensionsHasTimeAsTheLast() {
        byte[] two = VolumeSamples.join(new byte[SHORTS.length], SHORTS);
        VolumeSamples.write(folder, "itk.nrrd", VolumeSamples.join(fourDimensions("(2,0,0,0)", "(0,0,0,0.5)"), two));
        assertIsSample(LabelVolumeFiles.read(folder.resolve("itk.nrrd#1")));
        assertAxesRefused("found (2,0,0,0.1) for axis 0, expected one in space only", "(2,0,0,0.1)", "(0,0,0,0.5)");
        assertAxesRefused("found (0,1,0,0.5) for axis 3, expected one in time only", "(2,0,0,0)", "(0,1,0,0.5)");
    }

    private void assertAxesRefused(String message, String columns, String time) {
        byte[] file = VolumeSamples.join(fourDimensions(columns, time), VolumeSamples.join(SHORTS, SHORTS));
        VolumeSamples.write(folder, "turned.nrrd", file);
        assertThatThrownBy(() -> LabelVolumeFiles.read(folder.resolve("turned.nrrd#0")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining(message);
    }
}
