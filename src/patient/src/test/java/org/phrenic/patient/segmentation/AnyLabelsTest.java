package org.phrenic.patient.segmentation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;
import org.phrenic.patient.numbering.BoneNumbering;

/** A scan of any field of view, in which any structures of a thorax are labelled, is separated or refused. */
class AnyLabelsTest {
    private static final int SLICE = CageVoxels.COLUMNS * CageVoxels.ROWS;
    private static final int RIGHT_LUNG = 2;
    private static final int LEFT_LUNG = 3;
    private static final int CARTILAGES = 4;
    private static final int STERNUM = 5;
    private static final int LIVER = 6;

    private static final byte[] BODY = body();

    private static byte[] body() {
        CageVoxels cage = CageVoxels.withFloatingRibs().withVertebrae(1);
        for (int k = 44; k < 108; k += 4) {
            cage.ball(24, 30, k, 9, RIGHT_LUNG);
            cage.ball(65, 30, k, 9, LEFT_LUNG);
        }
        for (int number = 1; number <= 7; number++) {
            cage.ball(40, 6, 110 - 8 * number, 2, CARTILAGES);
            cage.ball(49, 6, 110 - 8 * number, 2, CARTILAGES);
        }
        for (int k = 52; k < 106; k += 2) {
            cage.ball(44.5, 6, k, 2, STERNUM);
        }
        cage.ball(30, 30, 30, 12, LIVER);
        return cage.labels;
    }

    /** Structures of the kinds that a draw takes; each kind has its own labels, one label, or none. */
    private static LabelTable table(SplittableRandom random) {
        Map<Integer, String> names = new TreeMap<>();
        int ribs = random.nextInt(4);
        if (ribs > 0) {
            names.putAll(CageVoxels.table(ribs == 1).structures());
            names.keySet().removeIf(label -> label < CageVoxels.rib(1, false));
        }
        int spine = random.nextInt(3);
        for (int number = 1; spine > 0 && number <= 12; number++) {
            String own = CageVoxels.table(false).structures().get(CageVoxels.vertebra(number));
            names.put(CageVoxels.vertebra(number), spine == 1 ? own : LabelTable.SPINE);
        }
        int lungs = random.nextInt(3);
        if (lungs > 0) {
            names.put(RIGHT_LUNG, lungs == 1 ? "lung_R" : LabelTable.LUNGS);
            names.put(LEFT_LUNG, lungs == 1 ? "lung_L" : LabelTable.LUNGS);
        }
        names.put(LIVER, "liver");
        if (random.nextBoolean()) {
            names.put(CARTILAGES, LabelTable.COSTAL_CARTILAGES);
        }
        if (random.nextBoolean()) {
            names.put(STERNUM, "sternum");
        }
        if (random.nextBoolean()) {
            // Single structures that are not labelled.
            names.keySet().removeIf(label -> label != LIVER && random.nextInt(3) == 0);
        }
        return new LabelTable(names);
    }

    /** All slices, or those of a field of view. */
    private static byte[] labels(SplittableRandom random, LabelTable table) {
        int first = random.nextBoolean() ? 0 : random.nextInt(CageVoxels.SLICES / 2);
        int last = random.nextBoolean() ? CageVoxels.SLICES : first + 20 + random.nextInt(CageVoxels.SLICES / 2 - 20);
        byte[] labels = Arrays.copyOfRange(BODY, SLICE * first, SLICE * last);
        for (int v = 0; v < labels.length; v++) {
            int label = labels[v] & LabelGrid.MAX_BYTE_LABEL;
            labels[v] = table.structures().containsKey(label) ? labels[v] : 0;
        }
        return labels;
    }

    static LongStream seeds() {
        return LongStream.rangeClosed(1, 30);
    }

    @ParameterizedTest
    @MethodSource("seeds")
    void isSeparatedOrRefusedWithAReason(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        LabelTable table = table(random);
        Segmentation s = new Segmentation(CageVoxels.volume(labels(random, table)), table, "scan");
        List<String> notes = new ArrayList<>();
        try {
            if (s.find(LabelTable.LUNGS) > 0) {
                LungSplitter.split(s, notes);
            }
            notes.addAll(BoneNumbering.numberRibs(s));
            if (s.find(LabelTable.COSTAL_CARTILAGES) > 0) {
                CartilageSplitter.split(s).ifPresent(notes::add);
            }
            notes.addAll(SegmentationRepair.mend(s));
            notes.addAll(LungPieces.name(s));
            s.findCuts();
        } catch (BadInputException refused) {
            assertThat(refused).hasMessageContaining("rib");
        }
        assertThat(notes).doesNotContain("");
    }
}
