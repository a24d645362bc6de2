package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.io.volume.NiftiWriter;
import org.phrenic.mesh.voxel.LabelGrid;

/** Names of labels that a file of its own states. */
class NamesBesideTest {
    private static final String DESCRIPTIONS = "################\n# ITK-SnAP Label Description File\n################\n"
            + "    0     0    0    0        0  0  0    \"Clear Label\"\n"
            + "    1   20    0    0        1  1  1    \"Right lung\"\n    2   40  0  0  0.5  1  1    \"Liver\"\n"
            + "    9   40    0    0        1  1  1    \"Spleen\"\n";
    private static final String COLOURS =
            "# Color table file lungs.ctbl\n0 background 0 0 0 0\n1 right_lung 1 2 3 255\n2 liver 4 5 6 255\n";
    private static final String ROWS =
            "1 spleen 157 108 162 255|2 kidney_right 185 102 83 255|5 rib_5_left 12 13 14 255"
                    + "|6 vertebrae_T5 12 13 14 255|7 \"Right lung\" 1 2 3 0|8 Stomach: 9 9 9 0|9 Left lung 1 2 3 255";

    @TempDir
    Path folder;

    private static LabelVolume volume(Map<Integer, String> names) {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {1, 2, 0}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        return new LabelVolume(grid, names, List.of());
    }

    private Map<Integer, String> structures(String path) {
        return LabelGuess.of(NamesBeside.added(folder.resolve(path), volume(Map.of())))
                .table()
                .map(LabelTable::structures)
                .orElse(Map.of());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "{'labels': {'background': 0, 'lung_right': 1, 'liver': 2, 'spleen': 3}, 'numTraining': 1}",
                "{'labels': {'0': 'background', '1': 'lung_right', '2': 'liver'}}",
                "{'reference': 'http:\\/\\/a.b', 'labels': {'lung\\u005fright': 1, 'liver': 2}}",
                "{\n\t'labels': {'background': 0, 'lung_right': [1], 'liver': 2, 'trunk': [1, 2]}}",
            })
    void aDataSetNamesTheLabelsInItsFolderAndTheOnesIn(String json) throws IOException {
        Files.writeString(folder.resolve("dataset.json"), json.replace('\'', '"'));
        assertThat(structures("case.nii.gz")).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
        assertThat(structures("labelsTr/case.nii.gz")).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
        assertThat(structures("labelsTr/./case.nii.gz")).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
        assertThat(structures("a/../labels/case.nii.gz")).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
        assertThat(structures("gt_segmentations/case.nii.gz")).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
        assertThat(structures("labelsTr/a/case.nii.gz")).isEmpty();
        assertThat(structures("labelsTr/../../case.nii.gz")).isEmpty();
        assertThat(structures("lungs/case.nii.gz")).isEmpty();
        assertThat(NamesBeside.added(folder.resolve("case.nii.gz"), volume(Map.of()))
                        .notes())
                .containsExactly("dataset.json names the labels");
    }

    /** Colours are no part of a name: with and without opacity, with quotes or a colon. */
    @ParameterizedTest
    @ValueSource(strings = {"", " 255"})
    void aColourTableGivesNamesWithoutColours(String opacity) throws IOException {
        String rows = ROWS.replaceAll(" (0|255)(?=\\||$)", opacity).replace('|', '\n');
        Path file = Files.writeString(
                folder.resolve("case.ctbl"), "  # colours\n0 background 0 0 0" + opacity + "\n" + rows);
        LabelGrid grid = LabelGrid.of(
                7, 1, 1, new byte[] {1, 8, 2, 9, 5, 7, 6}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelVolume volume = new LabelVolume(grid, Map.of(), List.of());
        LabelVolume named = NamesBeside.added(folder.resolve("case.nii.gz"), volume);
        assertThat(named.names())
                .hasToString("{1=spleen, 2=kidney_right, 5=rib_5_left, 6=vertebrae_T5, 7=Right lung, 8=Stomach,"
                        + " 9=Left lung}");
        String structures = "{1=spleen, 2=kidney_R, 5=rib_05_L, 6=vertebra_T05, 7=lung_R, 8=stomach, 9=lung_L}";
        assertThat(LabelGuess.of(named).require("case").structures()).hasToString(structures);
        assertThat(LabelTable.of(file.toString(), volume).structures()).hasToString(structures);
    }

    /** A name may hold numbers or end with one: each row ends with as many numbers as all rows have. */
    @ParameterizedTest
    @ValueSource(strings = {"", " 255"})
    void aNumberInANameIsNoColour(String opacity) throws IOException {
        String rows =
                "1 Rib 5 left 12 13 14|2 Right rib 6 12 13 14|3 Liver segment 4 of the left lobe 1 2 3|4 T 5 1 2 3"
                        + "|5 spleen 1 2 3";
        Files.writeString(folder.resolve("case.ctbl"), rows.replace("|", opacity + "\n") + opacity);
        LabelGrid grid =
                LabelGrid.of(5, 1, 1, new byte[] {1, 4, 2, 5, 3}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelVolume named =
                NamesBeside.added(folder.resolve("case.nii.gz"), new LabelVolume(grid, Map.of(), List.of()));
        assertThat(named.names())
                .hasToString("{1=Rib 5 left, 2=Right rib 6, 3=Liver segment 4 of the left lobe, 4=T 5, 5=spleen}");
        assertThat(LabelGuess.of(named).require("case").structures())
                .containsEntry(1, "rib_05_L")
                .containsEntry(2, "rib_06_R")
                .containsEntry(4, "vertebra_T05");
    }

    /** Notes and numbers of somebody under the name of the volume, and a data set that names no labels. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "case.txt | ``",
                "case.txt | `1 10 20 30 40\n2 11 21 31 41`",
                "case.txt | `1 2 3 4 5 6\n1 4 5 6 7 8`",
                "case.txt | `Labels of A. B.\n1 liver 1 2 3 255\n2 spleen 1 2 3 255`",
                "dataset.json | {\"channel_names\": {\"0\": \"CT\"}, \"numTraining\": 20, \"numTest\": 20}",
                "dataset.json | {\"labels\": [\"liver\", \"spleen\"], \"numTraining\": 1, \"liver\": 2}",
            })
    void aFileThatNamesNoLabelsIsPassedOver(String name, String text) throws IOException {
        Files.writeString(folder.resolve(name), text == null ? "" : text);
        LabelVolume volume = volume(Map.of());
        assertThat(NamesBeside.added(folder.resolve("case.nii.gz"), volume)).isEqualTo(volume);
        Files.write(folder.resolve("case.txt"), new byte[] {'M', (byte) 0xFC, 'l', 'l', 'e', 'r'});
        Files.deleteIfExists(folder.resolve("dataset.json"));
        assertThat(NamesBeside.added(folder.resolve("case.nii.gz"), volume)).isEqualTo(volume);
    }

    /** Beside labels of a tool may lie the data set of another task: what it names lies elsewhere in people. */
    @ParameterizedTest
    @CsvSource({
        "lung_right, lung_left, dataset.json names the labels",
        "liver, tumor, dataset.json is left aside: labels lie as those of lungmask and not as those that it names",
        "lung_left, lung_right,"
                + " dataset.json is left aside: labels lie as those of lungmask and not as those that it names",
        "kidney_right, kidney_left, dataset.json names the labels",
    })
    void aDataSetOfAnotherTaskIsLeftAside(String first, String second, String note) throws IOException {
        LabelVolume lungs = TrunkVoxels.labelled(NumberTable.named("lungmask").get(0));
        Files.writeString(
                folder.resolve("dataset.json"),
                String.format("{\"labels\": {\"background\": 0, \"%s\": 1, \"%s\": 2}}", first, second));
        LabelVolume named = NamesBeside.added(folder.resolve("case.nii.gz"), lungs);
        assertThat(named.notes()).last().isEqualTo(note);
        assertThat(named.names().isEmpty()).isEqualTo(note.contains("aside"));
    }

    /** Names that are unknown or missing do not make obstacles of what the numbers tell. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "rkid lkid gall eso IVC pancreas rad lad | dataset.json is left aside: labels are numbered as those of"
                        + " AMOS, and it names fewer structures",
                "right_kidney left_kidney gall_bladder esophagus postcava pancreas right_adrenal_gland"
                        + " left_adrenal_gland | dataset.json names the labels",
            })
    void namesOfFewerStructuresThanTheNumbersTellAreLeftAside(String names, String note) throws IOException {
        LabelVolume organs = TrunkVoxels.labelled(NumberTable.named("amos").get(0));
        String json =
                "{'labels': {'spleen': 1, '%s': 2, '%s': 3, '%s': 4, '%s': 5, 'liver': 6, 'stomach': 7, 'arota': 8,"
                        + " '%s': 9, '%s': 10, '%s': 11, '%s': 12, 'duodenum': 13, 'bladder': 14, 'prostate/uterus': 15}}";
        Files.writeString(folder.resolve("dataset.json"), String.format(json.replace('\'', '"'), (Object[])
                names.split(" ", -1)));
        LabelVolume named = NamesBeside.added(folder.resolve("case.nii.gz"), organs);
        assertThat(named.notes()).last().isEqualTo(note);
        assertThat(LabelGuess.of(named).require("case").structures())
                .containsEntry(2, "kidney_R")
                .containsEntry(8, "aorta")
                .containsEntry(11, "adrenal_gland_R")
                .hasSameSizeAs(LabelGuess.of(organs).require("case").structures());
    }

    /** Masks are numbered as their files come: label_10 before label_2. */
    @Test
    void aFolderOfMasksHasTheNamesOfItsFilesAlone() throws IOException {
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        LabelVolume masks = volume(Map.of(1, "label_10", 2, "label_2"));
        assertThat(NamesBeside.added(folder, masks)).isEqualTo(masks);
    }

    private LabelVolume read(String name) {
        return NamesBeside.added(folder.resolve(name), LabelVolumeFiles.read(folder.resolve(name)));
    }

    private void writeNrrd(String name, String type, String fields, String voxels) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(
                file,
                "NRRD0004\ntype: " + type + "\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 1 1\n"
                        + "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nencoding: text\n" + fields
                        + "\n" + voxels);
    }

    /** The folder of one volume of labels is read as the volume is: alone, beside images, and in a folder within. */
    @Test
    void theFolderOfOneVolumeHasTheNamesBesideTheVolume() throws IOException {
        NiftiWriter.write(folder.resolve("case.nii.gz"), volume(Map.of()).grid());
        Files.writeString(folder.resolve("case.txt"), DESCRIPTIONS);
        assertThat(read("").names()).containsEntry(1, "Right lung").containsEntry(2, "Liver");
        assertThat(structures("")).as("masks").isEmpty();
        writeNrrd("ct.nrrd", "short", "", "-1000 -1000 40");
        assertThat(read("").names()).containsEntry(2, "Liver");
        LabelVolume turned = GeometryOverride.axes(LabelVolumeFiles.read(folder), "RAS");
        assertThat(NamesBeside.added(folder, turned).names()).containsEntry(2, "Liver");
        Path scan = folder.resolve("scan/seg");
        NiftiWriter.write(
                Files.createDirectories(scan).resolve("case.nii.gz"),
                volume(Map.of()).grid());
        Files.writeString(folder.resolve("scan/dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        assertThat(read("scan").names()).containsEntry(2, "spleen");
    }

    /** Numbers for names are those of the volume where its folder holds no others, but those of files of masks. */
    @Test
    void segmentsWithNumbersForNamesHaveTheNamesBesideInAFolderAsWell() throws IOException {
        String segments = "Segment0_LabelValue:=1\nSegment0_Name:=Segment_1\n"
                + "Segment1_LabelValue:=2\nSegment1_Name:=Segment_2\n";
        writeNrrd("a/case.seg.nrrd", "uint8", segments, "1 2 0");
        Files.writeString(folder.resolve("a/dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        assertThat(read("a").names()).isEqualTo(Map.of(1, "heart", 2, "spleen"));
        writeNrrd("b/label_10.nrrd", "uint8", "", "1 0 0");
        writeNrrd("b/label_2.nrrd", "uint8", "", "0 1 0");
        Files.copy(folder.resolve("a/dataset.json"), folder.resolve("b/dataset.json"));
        assertThat(read("b").names()).isEqualTo(Map.of(1, "label_10", 2, "label_2"));
    }

    @ParameterizedTest
    @CsvSource({"case.nii.gz, case.txt", "case.seg.nrrd, case.label", "case.mha#1, case.ctbl"})
    void aFileOfTheSameNameNamesTheLabelsBeforeADataSet(String name, String beside) throws IOException {
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        Files.writeString(folder.resolve(beside), beside.endsWith("ctbl") ? COLOURS : DESCRIPTIONS);
        assertThat(structures(name)).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
    }

    @Test
    void aFileThatDoesNotMatchIsLeftAsideWithANote() throws IOException {
        Path file = folder.resolve("case.nii.gz");
        Files.writeString(folder.resolve("case.txt"), "Seen by A. B. on 3 May 2020\n");
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"liver\": 1}}");
        LabelVolume aside = NamesBeside.added(file, volume(Map.of()));
        assertThat(aside.names()).isEmpty();
        assertThat(aside.notes()).containsExactly("dataset.json is left aside: it has no name for label 2");
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"trunk\": [1, 2]}}");
        assertThat(NamesBeside.added(file, volume(Map.of())).notes())
                .containsExactly("dataset.json is left aside: it has no name for label 1 and 1 others");
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"quux\": 1, \"quuz\": 2}}");
        assertThat(NamesBeside.added(file, volume(Map.of())).notes())
                .containsExactly("dataset.json is left aside: it has no name of a structure for a label of the volume");
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\"");
        assertThat(NamesBeside.added(file, volume(Map.of())).notes())
                .singleElement()
                .satisfies(note -> assertThat(note).contains("dataset.json: ").endsWith("it is left aside"));
    }

    /**
     * A table of names that {@code phrenic info} shows finds its labels by them; one of numbers has no use for them.
     */
    @Test
    void aTableOfNamesAloneIsReadWithTheNamesBeside() throws IOException {
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        Path file = folder.resolve("case.nii.gz");
        LabelVolume volume = volume(Map.of());
        Path table = Files.writeString(folder.resolve("table.csv"), "name,structure\nheart,lung_L\nspleen,liver\n");
        LabelVolume named = NamesBeside.added(file, volume, Optional.of(table.toString()));
        assertThat(LabelTable.of(table.toString(), named).structures()).isEqualTo(Map.of(1, "lung_L", 2, "liver"));
        Files.writeString(table, "label,name,structure\n1,a,lung_L\n2,b,liver\n");
        assertThat(NamesBeside.added(file, volume, Optional.of(table.toString())))
                .isEqualTo(volume);
        assertThat(NamesBeside.added(file, volume, Optional.of("amos"))).isEqualTo(volume);
        assertThat(NamesBeside.added(file, volume, Optional.empty()).names()).containsEntry(2, "spleen");
    }

    /** A table is needed just where names are unknown, or too few of them are known. */
    @Test
    void aTableOfNamesAloneTellsTheStructuresOfUnknownNames() throws IOException {
        Path file = folder.resolve("case.nii.gz");
        Path table = Files.writeString(folder.resolve("table.csv"), "name,structure\nfoie_a,liver\nrkid,kidney_R\n");
        Files.writeString(folder.resolve("case.txt"), DESCRIPTIONS);
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"foie_a\": 1, \"quux\": 2}}");
        LabelVolume named = NamesBeside.added(file, volume(Map.of()), Optional.of(table.toString()));
        assertThat(named.notes())
                .containsExactly(
                        "case.txt is left aside: it has no name of the table", "dataset.json names the labels");
        assertThat(LabelTable.of(table.toString(), named).structures()).isEqualTo(Map.of(1, "liver", 2, "other_quux"));
        LabelVolume segments = volume(Map.of(1, "Segment_1", 2, "Segment_2"));
        Path own = Files.writeString(folder.resolve("own.csv"), "name,structure\nSegment_1,heart\nfoie_a,liver\n");
        assertThat(NamesBeside.added(file, segments, Optional.of(own.toString())))
                .isEqualTo(segments);
        LabelVolume organs = TrunkVoxels.labelled(NumberTable.named("amos").get(0));
        Files.writeString(folder.resolve("dataset.json"), numbered("spleen", "rkid", "lkid"));
        assertThat(NamesBeside.added(file, organs, Optional.of(table.toString()))
                        .names())
                .containsEntry(2, "rkid");
    }

    /** A data set of AMOS's numbers of labels with one more, in which the labels after these have no known names. */
    private static String numbered(String... names) {
        return IntStream.rangeClosed(1, 16)
                .mapToObj(label ->
                        String.format("\"%s\": %d", label > names.length ? "quux_" + label : names[label - 1], label))
                .collect(Collectors.joining(", ", "{\"labels\": {", "}}"));
    }

    /** A name that is the tool's, and one of a label that the tool does not have, make no comparison of places. */
    @Test
    void oneNameThatIsTheToolsDoesNotContradictIt() throws IOException {
        LabelVolume organs = TrunkVoxels.labelled(NumberTable.named("amos").get(0));
        LabelGrid grid = organs.grid();
        byte[] labels = new byte[grid.voxelCount()];
        for (int v = 0; v < labels.length; v++) {
            labels[v] = (byte) (v == 1 ? 16 : grid.label(v));
        }
        LabelVolume added = new LabelVolume(
                LabelGrid.of(grid.columns(), grid.rows(), grid.slices(), labels, grid.toMm()), Map.of(), List.of());
        Files.writeString(
                folder.resolve("dataset.json"),
                numbered().replace("quux_10", "pancreas").replace("quux_16", "tumor"));
        for (LabelVolume volume : List.of(organs, added)) {
            assertThat(NamesBeside.added(folder.resolve("case.nii.gz"), volume).notes())
                    .containsExactly("dataset.json is left aside: labels are numbered as those of AMOS, and it names"
                            + " fewer structures");
        }
    }

    @Test
    void namesInTheVolumeComeFirst() throws IOException {
        Files.writeString(folder.resolve("dataset.json"), "{\"labels\": {\"heart\": 1, \"spleen\": 2}}");
        Path file = folder.resolve("case.nii.gz");
        LabelVolume named = volume(Map.of(1, "liver", 2, "Segment_2"));
        assertThat(NamesBeside.added(file, named)).isEqualTo(named);
        assertThat(NamesBeside.added(file, volume(Map.of(1, "Segment_1"))).names())
                .isEqualTo(Map.of(1, "heart", 2, "spleen"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "a.json | {\"1\": \"right lung\", \"2\": \"liver\"}",
                "a.json | {\"right lung\": 1, \"liver\": 2, \"spleen\": 7}",
                "a.json | {\"labels\": {\"right lung\": 1, \"liver\": 2}}",
                "a.txt | `1 7 0 0 1 1 1 \"Right lung\"\n2 8 0 0 1 1 1 \"Liver\"\n`",
                "a.ctbl | `1 right_lung 1 2 3 255\n2 liver 1 2 3 255\n`",
                "a.ctbl | `Index Name R G B A\n1 right_lung 1 2 3 255\n2 liver 1 2 3 255\n`",
                "LUT.txt | `1 Right-Lung: 1 2 3 0\n2 \"Liver\" 1 2 3 0\n`",
                "a.csv | `label,name\n1,right lung\n2,liver\n`",
                "a.csv | `LabelValue,Name,Color_R\n0,none,0\n1,right lung,3\n2,liver,4\n`",
                "a.csv | `label,name,structure\n1,heart,lung_R\n2,spleen,liver\n`",
                "a.txt | `label,structure\n1,lung_R\n2,liver\n`",
            })
    void aFileOfNamesMayBeAskedFor(String name, String text) throws IOException {
        Path file = Files.writeString(folder.resolve(name), text);
        LabelVolume volume = volume(Map.of(1, "heart", 2, "spleen"));
        assertThat(LabelTable.of(file.toString(), volume).structures()).isEqualTo(Map.of(1, "lung_R", 2, "liver"));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{'liver': 7} | found no name for a label of the volume, expected some such as liver",
                "{'quux': 1} | found no name of a structure for a label of the volume, as 'quux', expected",
                "{'liver': 1, 'spleen': 1} | found label 1 for 'liver' and 'spleen', expected one name",
                "{'liver': 'big'} | found no names of labels, expected \"labels\" with a number for each name",
            })
    void aFileOfNamesThatTellsNoLabelIsRefused(String json, String problem) throws IOException {
        Path file = Files.writeString(folder.resolve("a.json"), json.replace('\'', '"'));
        assertThatThrownBy(() -> LabelTable.of(file.toString(), volume(Map.of())))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("a.json: " + problem);
    }
}
