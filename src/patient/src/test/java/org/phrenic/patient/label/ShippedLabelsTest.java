package org.phrenic.patient.label;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.phrenic.anatomy.DiaphragmSide;
import org.phrenic.anatomy.StructureKind;
import org.phrenic.anatomy.StructureName;

/**
 * The tables of TotalSegmentator's labels. Sides and levels are told by both names of a row; the numbers are those of
 * the class lists of its versions ("total": in version 2 rib_left_1 is 92 and rib_right_1 is 104; in version 1
 * rib_left_1 is 58, rib_right_1 is 70, heart_myocardium is 44, and 104 is the last, urinary_bladder).
 */
class ShippedLabelsTest {
    private static final Pattern RIB = Pattern.compile("(\\d+),rib_(left|right)_(\\d+),(\\S+)");

    /** Organs that the diaphragm does not press on, or that pass through it. */
    private static final Set<String> FAR_ORGANS = Set.of(
            "brain", "oesophagus", "prostate", "rectum", "spinal_cord", "thyroid_gland", "urinary_bladder", "uterus");

    private static List<String> rows(String file) throws IOException {
        return Files.readAllLines(Path.of("data", "labels", file));
    }

    @ParameterizedTest
    @CsvSource({"totalsegmentator.csv, 92, 104", "totalsegmentator-v1.csv, 58, 70"})
    void ribsKeepTheirSidesAndLevels(String file, int firstLeft, int firstRight) throws IOException {
        int ribs = 0;
        for (String row : rows(file)) {
            Matcher rib = RIB.matcher(row);
            if (rib.matches()) {
                int level = Integer.parseInt(rib.group(3));
                boolean left = rib.group(2).equals("left");
                assertThat(Integer.parseInt(rib.group(1)))
                        .as(row)
                        .isEqualTo((left ? firstLeft : firstRight) + level - 1);
                assertThat(rib.group(4)).as(row).isEqualTo(String.format("rib_%02d_%s", level, left ? "L" : "R"));
                ribs++;
            }
        }
        assertThat(ribs).isEqualTo(24);
    }

    @Test
    void versionOneHasTheNumbersOfItsClassList() throws IOException {
        assertThat(rows("totalsegmentator-v1.csv"))
                .hasSize(105)
                .contains(
                        "17,lung_lower_lobe_right,lung_R",
                        "18,vertebrae_L5,vertebra_L05",
                        "41,vertebrae_C1,vertebra_C1")
                .contains(
                        "44,heart_myocardium,heart", "81,rib_right_12,rib_12_R", "104,urinary_bladder,urinary_bladder");
    }

    /** VerSe numbers the vertebrae that only some people have after all others. */
    @Test
    void theThirteenthThoracicVertebraOfVerSeIsKnown() {
        assertThat(NumberTable.named("verse")).singleElement().satisfies(table -> assertThat(table.structures())
                .containsEntry(25, "bone_vertebra_L6")
                .containsEntry(28, "bone_vertebra_T13"));
    }

    /** The bones below the lumbar spine, and the tumour of FLARE's third year, which is a target and no obstacle. */
    @Test
    void bonesBelowTheSpineAndTumoursKeepTheirMeaning() {
        assertThat(NumberTable.named("verse")).singleElement().satisfies(table -> assertThat(table.structures())
                .containsEntry(26, "sacrum")
                .containsEntry(27, "bone_coccyx"));
        assertThat(NumberTable.named("flare")).singleElement().satisfies(table -> assertThat(table.structures())
                .containsEntry(14, "lesion_tumor"));
    }

    /** The diaphragm presses on the organs of the upper abdomen, by whatever name a table calls them. */
    @Test
    void organsNearTheDiaphragmLieOnASideOfIt() {
        assertThat(NumberTable.ALL)
                .allSatisfy(table -> assertThat(table.structures().values())
                        .as(table.title())
                        .filteredOn(name -> StructureName.parse(name)
                                .filter(known -> known.kind() == StructureKind.ORGAN)
                                .isPresent())
                        .filteredOn(name -> DiaphragmSide.of(StructureKind.ORGAN, name) == DiaphragmSide.NEITHER)
                        .isSubsetOf(FAR_ORGANS));
    }

    /** Every structure of a table is one that a thorax folder may hold, and names stand for the same structures. */
    @Test
    void tablesHoldKnownStructures() {
        assertThat(NumberTable.ALL).hasSizeGreaterThan(10).allSatisfy(table -> assertThat(
                        table.structures().values())
                .as(table.title())
                .allMatch(LabelTable::isStructure));
        Map<String, String> names = new TreeMap<>();
        NumberTable.ALL.forEach(table -> table.names()
                .forEach((name, structure) -> assertThat(names.merge(name, structure, (a, b) -> a))
                        .as(table.title() + ", " + name)
                        .isEqualTo(structure)));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "totalsegmentator.csv",
                "totalsegmentator-v1.csv",
                "totalsegmentator-mr.csv",
                "mrsegmentator.csv",
                "ribseg.csv",
                "vibesegmentator.csv",
                "vista3d.csv",
                "lungmask.csv",
                "lungmask-lobes.csv",
                "amos.csv",
                "btcv.csv",
                "flare.csv",
                "word.csv",
                "chaos.csv",
                "covid-19-ct-seg.csv",
                "cads-organs.csv"
            })
    void whatIsNamedLeftOrRightBecomesAStructureOfThatSide(String file) throws IOException {
        for (String row : rows(file)) {
            String[] cells = row.split(",");
            boolean kept = cells.length > 2 && (cells[2].endsWith("_L") || cells[2].endsWith("_R"));
            if (kept && !cells[1].startsWith("vertebrae")) {
                assertThat(cells[1]).as(row).contains(cells[2].endsWith("_L") ? "left" : "right");
            }
        }
    }

    /** A file that names its labels as a tool does gets the structures of the tool's table. */
    @Test
    void everyNameOfATableStandsForItsStructure() {
        NumberTable.ALL.forEach(table -> table.names()
                .forEach((name, structure) ->
                        assertThat(LabelNames.structure(name)).as(name).contains(structure)));
    }
}
