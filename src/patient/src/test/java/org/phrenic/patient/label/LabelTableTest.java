package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;

class LabelTableTest {
    @TempDir
    Path folder;

    private LabelTable read(String rows, Map<Integer, String> names) throws IOException {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {5, 6, 0}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        return LabelTable.read(
                Files.writeString(folder.resolve("labels.csv"), rows), new LabelVolume(grid, names, List.of()));
    }

    @Test
    void aLabelOfTwoStructuresIsRefused() {
        assertThatThrownBy(() -> read("label,structure\n5,liver\n6,heart\n5,spleen\n", Map.of()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("labels.csv: line 4, column 'label'")
                .hasMessageContaining("label 5 for 'spleen' and, in a row above, for 'liver', expected one structure");
        assertThatThrownBy(() -> read("name,structure\na,liver\na,spleen\n", Map.of(5, "a", 6, "b")))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("labels.csv: line 3, column 'name'")
                .hasMessageContaining("label 5");
    }

    @Test
    void aLabelMayBeRepeatedAndAStructureMayHaveSeveralLabels() throws IOException {
        assertThat(read("label,structure\n5,liver\n6,liver\n5,liver\n", Map.of())
                        .structures())
                .containsExactlyInAnyOrderEntriesOf(Map.of(5, "liver", 6, "liver"));
    }

    @Test
    void aStructureIsKnownWithoutLeadingZerosAndInAnyCase() throws IOException {
        assertThat(read("label,structure\n5,rib_5_R\n6,VERTEBRA_t1\n", Map.of()).structures())
                .isEqualTo(Map.of(5, "rib_05_R", 6, "vertebra_T01"));
        assertThat(read("label,structure\n5,costal_cartilage_5_l\n6,vertebra_L1\n", Map.of())
                        .structures())
                .isEqualTo(Map.of(5, "costal_cartilage_05_L", 6, "vertebra_L01"));
        assertThat(read("label,structure\n5,Lungs\n6,Costal_Cartilages\n", Map.of())
                        .structures())
                .isEqualTo(Map.of(5, "lungs", 6, "costal_cartilages"));
        assertThat(read("label,structure\n5,RIBS\n6,Ignore\n", Map.of()).structures())
                .isEqualTo(Map.of(5, "ribs", 6, "ignore"));
        assertThat(read("label,structure\n5,Ribs_r\n6,ribs_l\n", Map.of()).structures())
                .isEqualTo(Map.of(5, "ribs_R", 6, "ribs_L"));
    }

    /** DICOM states the side of a segment apart from its label, and it stands before the name that is read. */
    @Test
    void aNameWithoutASideIsThatOfTheSegmentOfThisSide() throws IOException {
        Map<Integer, String> sides = Map.of(5, "Left Kidney", 6, "right Kidney");
        assertThat(read("name,structure\nKidney,kidney_L\n", Map.of(5, "Left Kidney", 6, "Liver"))
                        .structures())
                .isEqualTo(Map.of(5, "kidney_L", 6, "liver"));
        assertThat(read("name,structure\nKidney,kidney_R\nKidney,kidney_L\n", sides))
                .isEqualTo(new LabelTable(Map.of(5, "kidney_L", 6, "kidney_R")));
        assertThat(read("name,structure\nKidney,ignore\n", sides))
                .as("a structure without a side")
                .isEqualTo(new LabelTable(Map.of(5, "ignore", 6, "ignore")));
        assertThat(read("name,structure\nKidney,ignore\nLeft Kidney,kidney_L\n", sides))
                .as("a name that stands in the table")
                .isEqualTo(new LabelTable(Map.of(5, "kidney_L", 6, "ignore")));
        LabelTable other =
                read("name,structure\nKidney,kidney_L\nLiver,liver\n", Map.of(5, "Liver", 6, "Right Kidney"));
        assertThat(other.structures()).isEqualTo(Map.of(5, "liver", 6, "kidney_R"));
        assertThat(other.missing()).as("the other side").containsExactly("name 'Kidney' (kidney_L)");
    }

    @Test
    void aLabelBeyondThoseOfAVolumeIsRefused() {
        assertThatThrownBy(() -> read("label,structure\n5,liver\n70000,heart\n", Map.of()))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("labels.csv: line 3, column 'label'")
                .hasMessageContaining("found 70000, expected a whole number from 1 to 65535");
    }

    /**
     * Kidneys of both sides have one label, and other orders of the four organs fit as well: it has to be asked for.
     */
    @Test
    void theFourLabelsOfFlare21AreTakenWhereTheyAreAskedFor() {
        LabelVolume trunk = TrunkVoxels.labelled(NumberTable.named("flare21").get(0));
        assertThat(LabelGuess.of(trunk).source()).isEqualTo(LabelGuess.Source.NONE);
        assertThat(LabelTable.of("flare21", trunk).structures())
                .isEqualTo(Map.of(1, "liver", 2, "organ_kidneys", 3, "spleen", 4, "pancreas"));
    }

    /** Few structures, or the order of another table upside down: as many files of others have such numbers. */
    @ParameterizedTest
    @CsvSource({
        "segthor, 0, 2, heart",
        "covid-19-ct-seg, 0, 1, lung_L",
        "mm-whs, 0, 820, aorta",
        "cads, 0, 16, lung_R",
        "cads, 1, 6, vertebra_T12",
    })
    void tablesThatFitOthersAsWellAreTakenWhereTheyAreAskedFor(String name, int which, int label, String structure) {
        NumberTable table = NumberTable.named(name).get(which);
        assertThat(NumberTable.ALL).doesNotContain(table);
        assertThat(table.structures().values()).allMatch(LabelTable::isStructure);
        LabelVolume trunk = TrunkVoxels.labelled(table);
        assertThat(LabelTable.of(name, trunk).structures()).containsEntry(label, structure);
    }

    @Test
    void theNameOfATableIsTakenInAnyCaseAndAnotherIsAnsweredWithTheNamesThereAre() {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {5, 6, 0}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelVolume volume = new LabelVolume(grid, Map.of(), List.of());
        assertThat(LabelTable.of("TotalSegmentator", volume).structures()).containsEntry(5, "liver");
        assertThatThrownBy(() -> LabelTable.of("amos22", volume))
                .isInstanceOf(BadInputException.class)
                .hasMessageContaining("--labels amos22: found neither a file nor a table of this name, expected a CSV"
                        + " file, lungs or one of totalsegmentator,")
                .hasMessageContaining("amos, btcv, flare,");
        assertThatThrownBy(() -> LabelTable.of("none.csv", volume))
                .hasMessageContaining("none.csv: found no such file");
    }

    /** Programs that write a tool's labels again often name them otherwise, but keep their numbers. */
    @Test
    void aToolThatIsAskedForTellsLabelsByNumbersWhereNoneHasANameOfIts() {
        LabelGrid grid = LabelGrid.of(3, 1, 1, new byte[] {5, 6, 0}, new double[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0});
        LabelVolume volume = new LabelVolume(grid, Map.of(5, "Segment_1", 6, "Segment_2"), List.of());
        assertThat(LabelTable.of("totalsegmentator", volume).structures())
                .containsEntry(5, "liver")
                .containsEntry(6, "stomach");
        LabelVolume named = new LabelVolume(grid, Map.of(5, "spleen", 6, "Segment_2"), List.of());
        assertThat(LabelTable.of("totalsegmentator", named).structures())
                .isEqualTo(Map.of(5, "spleen", 6, "other_segment_2"));
    }
}
