package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * Splits costal cartilages that share one label. Each voxel is assigned to the rib with the shortest voxel path through
 * cartilage; paths begin at the cartilage within {@value #GAP} voxels and {@value #GAP_MM} mm, or one voxel, of a rib,
 * of several ribs the nearest.
 */
public final class CartilageSplitter {
    private static final int CARTILAGES = 10;
    /** Maximum gap between rib and cartilage along each direction of the grid, in voxels. */
    private static final int GAP = 2;
    /** The same in mm, where voxels are smaller than this. */
    private static final double GAP_MM = 8;
    /** Share of the cartilage from which a loose piece is no speck, as of an organ, and what is left out is noted. */
    private static final double SPECK_SHARE = 0.002;
    /** Largest distance of a loose piece of cartilage from its rib, mm. */
    private static final double REACH_MM = 15;
    /** Number of voxels of a loose piece from which distances are measured. */
    private static final int SAMPLES = 200;

    private CartilageSplitter() {}

    /** Replaces the common cartilage segment by one per rib. Returns a note if some voxels are connected to no rib. */
    public static Optional<String> split(Segmentation segmentation) {
        int all = segmentation.find(LabelTable.COSTAL_CARTILAGES);
        List<String> names = new ArrayList<>();
        byte[] markOfSegment = new byte[LabelGrid.MAX_BYTE_LABEL + 1];
        for (String side : List.of("R", "L")) {
            for (int level = 1; level <= CARTILAGES; level++) {
                int rib = segmentation.find(String.format(Locale.ROOT, "rib_%02d_%s", level, side));
                if (rib > 0) {
                    names.add(String.format(Locale.ROOT, "costal_cartilage_%02d_%s", level, side));
                    markOfSegment[rib] = (byte) names.size();
                }
            }
        }
        VoxelRegion region = new VoxelRegion(segmentation, all);
        byte[] marks = new byte[region.cells()];
        BitSet specks = specks(segmentation, markOfSegment);
        int[] gap = gap(segmentation);
        for (int cell = 0; cell < marks.length; cell++) {
            if (region.isMember(cell)) {
                marks[cell] = nearestRib(segmentation, markOfSegment, specks, region.voxel(cell), gap);
            }
        }
        region.growRegions(marks);
        markLoosePieces(segmentation, region, marks, markOfSegment);
        byte[] segment = new byte[names.size() + 1];
        int lost = 0;
        int total = 0;
        for (int cell = 0; cell < marks.length; cell++) {
            if (region.isMember(cell)) {
                total++;
                int mark = marks[cell];
                lost += mark == 0 ? 1 : 0;
                if (mark > 0 && segment[mark] == 0) {
                    segment[mark] = (byte) segmentation.segment(names.get(mark - 1));
                    segmentation.inheritFrom(names.get(mark - 1), LabelTable.COSTAL_CARTILAGES);
                }
                segmentation.voxels[region.voxel(cell)] = segment[mark];
            }
        }
        return lost < SPECK_SHARE * total
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "%s: %.1f %% of it left out, no rib of the scan leads to it",
                        LabelTable.COSTAL_CARTILAGES,
                        100.0 * lost / total));
    }

    /** Voxels of pieces of ribs that are too small to lead to a cartilage. */
    private static BitSet specks(Segmentation segmentation, byte[] markOfSegment) {
        BitSet specks = new BitSet();
        VoxelRuns runs = new VoxelRuns(segmentation, markOfSegment, false);
        for (int run = 0; run < runs.count(); run++) {
            if (runs.size(runs.component(run)) < SegmentationRepair.SPECK_VOXELS) {
                specks.set(runs.from(run), runs.to(run));
            }
        }
        return specks;
    }

    /**
     * Marks the pieces that no path connects to a rib, but specks, with the nearest rib that has no cartilage yet; the
     * largest piece chooses first.
     */
    private static void markLoosePieces(
            Segmentation segmentation, VoxelRegion region, byte[] marks, byte[] markOfSegment) {
        int least = (int) Math.max(SegmentationRepair.SPECK_VOXELS, Math.ceil(SPECK_SHARE * region.memberCount()));
        for (IntList cells : region.unmarkedComponents(marks, least)) {
            boolean[] taken = new boolean[LabelGrid.MAX_BYTE_LABEL + 1];
            for (byte mark : marks) {
                taken[mark] = mark > 0 || taken[mark];
            }
            byte nearest = nearest(segmentation, region, cells, markOfSegment, taken);
            for (int i = 0; i < cells.size(); i++) {
                marks[cells.get(i)] = nearest;
            }
        }
    }

    /** Mark of the nearest free rib within reach of some cells; 0 if there is none. */
    private static byte nearest(
            Segmentation segmentation, VoxelRegion region, IntList cells, byte[] markOfSegment, boolean[] taken) {
        double least = REACH_MM * REACH_MM;
        byte nearest = 0;
        int stride = Math.max(1, cells.size() / SAMPLES);
        for (int v = 0; v < segmentation.voxels.length; v++) {
            byte mark = markOfSegment[segmentation.segmentAt(v)];
            if (mark == 0 || taken[mark]) {
                continue;
            }
            for (int i = 0; i < cells.size(); i += stride) {
                double square = squareDistance(segmentation, v, region.voxel(cells.get(i)));
                if (square < least) {
                    least = square;
                    nearest = mark;
                }
            }
        }
        return nearest;
    }

    /** Voxels along each direction across which a rib leads to its cartilage. */
    private static int[] gap(Segmentation segmentation) {
        LabelGrid grid = segmentation.grid();
        int[] gap = new int[3];
        Arrays.setAll(gap, direction -> Math.max(1, Math.min(GAP, (int) (GAP_MM / grid.spacing(direction)))));
        return gap;
    }

    private static double squareDistance(Segmentation segmentation, int a, int b) {
        double square = 0;
        for (int row = 0; row < 3; row++) {
            double d = segmentation.coordinate(a, row) - segmentation.coordinate(b, row);
            square += d * d;
        }
        return square;
    }

    /** Mark of the nearest rib within the gap of a voxel, the lowest of equally near ones; 0 if there is none. */
    private static byte nearestRib(
            Segmentation segmentation, byte[] markOfSegment, BitSet specks, int voxel, int[] gap) {
        int i = voxel % segmentation.columns;
        int j = voxel / segmentation.columns % segmentation.rows;
        int k = voxel / segmentation.columns / segmentation.rows;
        byte nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int z = Math.max(0, k - gap[2]); z <= Math.min(segmentation.slices - 1, k + gap[2]); z++) {
            for (int y = Math.max(0, j - gap[1]); y <= Math.min(segmentation.rows - 1, j + gap[1]); y++) {
                for (int x = Math.max(0, i - gap[0]); x <= Math.min(segmentation.columns - 1, i + gap[0]); x++) {
                    int near = x + segmentation.columns * (y + segmentation.rows * z);
                    byte mark = specks.get(near) ? 0 : markOfSegment[segmentation.segmentAt(near)];
                    double square = mark > 0 ? squareDistance(segmentation, voxel, near) : Double.POSITIVE_INFINITY;
                    if (square < least || (square == least && mark < nearest)) {
                        least = square;
                        nearest = mark;
                    }
                }
            }
        }
        return nearest;
    }
}
