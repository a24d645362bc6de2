package org.phrenic.patient.segmentation;

import java.util.Map;
import java.util.TreeMap;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * A rib cage of voxels of 3 mm: twelve pairs of ribs as sloping half ellipses of 9 mm thickness, 24 mm apart, and
 * twelve vertebrae. Labels as of TotalSegmentator.
 */
public final class CageVoxels {
    public static final int COLUMNS = 90;
    public static final int ROWS = 60;
    public static final int SLICES = 130;
    public static final double SPACING_MM = 3;
    private static final int FIRST_LEFT = 92;
    private static final int FIRST_RIGHT = 104;
    private static final int T1 = 43;

    public final byte[] labels = new byte[COLUMNS * ROWS * SLICES];

    /** Label of a rib by its number and side. */
    public static int rib(int number, boolean right) {
        return (right ? FIRST_RIGHT : FIRST_LEFT) + number - 1;
    }

    public static int vertebra(int number) {
        return T1 + 1 - number;
    }

    /** Slice of the centre of a vertebra. */
    public static int vertebraSlice(int number) {
        return 123 - 8 * number;
    }

    /** Adds ribs from a number to twelve. */
    public CageVoxels withRibs(int first) {
        for (int number = first; number <= 12; number++) {
            for (int step = 0; step <= 400; step++) {
                double angle = Math.PI * step / 400;
                // From the spine at the back, round the side, to the front; 36 mm lower there.
                double x = 36 * StrictMath.sin(angle) + 6;
                double y = 30 + 22 * StrictMath.cos(angle);
                double z = 124 - 8 * number - 12 * angle / Math.PI;
                ball(44.5 - x, y, z, 1.6, rib(number, true));
                ball(44.5 + x, y, z, 1.6, rib(number, false));
            }
        }
        return this;
    }

    /** The cage, with ribs 11 and 12 as long over the rib above as those of people. */
    public static CageVoxels withFloatingRibs() {
        CageVoxels cage = new CageVoxels().withRibs(1);
        cage.shorten(11, 20);
        cage.shorten(12, 43);
        return cage;
    }

    /** Takes away what of a pair of ribs lies before a row. */
    public void shorten(int number, int row) {
        for (int v = 0; v < labels.length; v++) {
            int label = labels[v] & LabelGrid.MAX_BYTE_LABEL;
            boolean before = v / COLUMNS % ROWS < row;
            if (before && (label == rib(number, true) || label == rib(number, false))) {
                labels[v] = 0;
            }
        }
    }

    public CageVoxels withVertebrae(int first) {
        for (int number = first; number <= 12; number++) {
            ball(44.5, 50, vertebraSlice(number), 3.2, vertebra(number));
        }
        return this;
    }

    public void ball(double x, double y, double z, double radius, int label) {
        for (int k = (int) (z - radius); k <= z + radius; k++) {
            for (int j = (int) (y - radius); j <= y + radius; j++) {
                for (int i = (int) (x - radius); i <= x + radius; i++) {
                    double square = (i - x) * (i - x) + (j - y) * (j - y) + (k - z) * (k - z);
                    if (square <= radius * radius && at(i, j, k) == 0) {
                        labels[i + COLUMNS * (j + ROWS * k)] = (byte) label;
                    }
                }
            }
        }
    }

    public int at(int i, int j, int k) {
        return labels[i + COLUMNS * (j + ROWS * k)] & LabelGrid.MAX_BYTE_LABEL;
    }

    /** The voxels in LPS, the first one at the origin. */
    public LabelVolume volume() {
        return volume(labels.clone());
    }

    /** Whole slices of voxels of this size in LPS, the first one at the origin. */
    public static LabelVolume volume(byte[] labels) {
        return volume(labels, SPACING_MM);
    }

    /** The same, of slices at a distance in mm: ribs are eight slices apart. */
    public static LabelVolume volume(byte[] labels, double apart) {
        double s = SPACING_MM;
        int slices = labels.length / (COLUMNS * ROWS);
        LabelGrid grid =
                LabelGrid.of(COLUMNS, ROWS, slices, labels, new double[] {s, 0, 0, 0, 0, s, 0, 0, 0, 0, apart, 0});
        return new LabelVolume(grid, Map.of(), java.util.List.of());
    }

    public Segmentation segmentation(LabelTable table) {
        return new Segmentation(volume(), table, "scan");
    }

    /** Voxels of each rib by its name. */
    public static TreeMap<String, Integer> ribCounts(Segmentation s) {
        TreeMap<String, Integer> counts = new TreeMap<>();
        int[] all = s.counts();
        s.names().stream()
                .filter(name -> name.startsWith("rib_") && all[s.find(name)] > 0)
                .forEach(name -> counts.put(name, all[s.find(name)]));
        return counts;
    }

    /** The table of TotalSegmentator, with all ribs under one label of the table if wanted. */
    public static LabelTable table(boolean commonRibs) {
        Map<Integer, String> structures = new TreeMap<>();
        for (int number = 1; number <= 12; number++) {
            structures.put(vertebra(number), String.format(java.util.Locale.ROOT, "vertebra_T%02d", number));
            for (boolean right : new boolean[] {true, false}) {
                String name = String.format(java.util.Locale.ROOT, "rib_%02d_%s", number, right ? "R" : "L");
                structures.put(rib(number, right), commonRibs ? LabelTable.RIBS : name);
            }
        }
        return new LabelTable(structures);
    }
}
