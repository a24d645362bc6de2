package org.phrenic.patient.segmentation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.IntList;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.voxel.CutPlane;
import org.phrenic.mesh.voxel.LabelGrid;
import org.phrenic.patient.label.LabelTable;

/**
 * Voxels of the requested structures, cropped to their bounding box. The segment number of a structure is the index of
 * its name plus 1.
 */
public final class Segmentation {
    private static final int MAX_SEGMENTS = LabelGrid.MAX_BYTE_LABEL;
    /**
     * Number of structures that reach the same outermost slice from which on the scan ends there. By themselves
     * people's structures end at heights of their own.
     */
    private static final int CUT_STRUCTURES = 5;
    /** Least cross-section in that slice over the structure's greatest: in a thick slice several may taper off. */
    private static final double CUT_SHARE = 0.3;

    private static final int MAX_LISTED = 8;

    final int columns;
    final int rows;
    final int slices;
    /** Segment number of each voxel; 0 for no segment. */
    byte[] voxels;

    private final double[] toMm;
    /**
     * Whether the box begins at the first voxel and ends at the last of the volume, for each direction, or at empty
     * slices with which a volume is filled up beyond the end of a scan.
     */
    private final boolean[] atEnd = new boolean[6];

    private final List<String> names = new ArrayList<>();
    /** Ends of the scan that each structure touches. */
    private final Map<String, List<CutPlane>> cuts = new TreeMap<>();
    /** Labels that each structure was built from. */
    private final Map<String, List<Integer>> labels = new LinkedHashMap<>();

    /**
     * Crops a volume to the structures of a table.
     *
     * @throws BadInputException if the volume contains none of the structures
     */
    public Segmentation(LabelVolume volume, LabelTable map, String file) {
        LabelGrid all = volume.grid();
        int[] counts = all.counts();
        byte[] segmentOfLabel = new byte[LabelGrid.MAX_LABEL + 1];
        for (Map.Entry<Integer, String> entry : map.structures().entrySet()) {
            int label = entry.getKey();
            boolean wanted = !entry.getValue().equals(LabelTable.IGNORE);
            if (wanted && label < counts.length && counts[label] > 0) {
                segmentOfLabel[label] = (byte) segment(entry.getValue());
                labels.computeIfAbsent(entry.getValue(), name -> new ArrayList<>())
                        .add(label);
            }
        }
        if (names.isEmpty()) {
            throw new BadInputException(file + ": found " + held(counts) + " and none of the "
                    + map.structures().size() + " labels asked for, expected at least one");
        }
        int[] box = all.box(label -> segmentOfLabel[label] != 0);
        columns = box[3] - box[0] + 1;
        rows = box[4] - box[1] + 1;
        slices = box[5] - box[2] + 1;
        voxels = new byte[columns * rows * slices];
        for (int k = 0; k < slices; k++) {
            for (int j = 0; j < rows; j++) {
                int from = box[0] + all.columns() * (box[1] + j + all.rows() * (box[2] + k));
                int to = columns * (j + rows * k);
                for (int i = 0; i < columns; i++) {
                    voxels[to + i] = segmentOfLabel[all.label(from + i)];
                }
            }
        }
        toMm = all.toMm(box[0], box[1], box[2]);
        int[] last = {all.columns() - 1, all.rows() - 1, all.slices() - 1};
        for (int direction = 0; direction < 3; direction++) {
            atEnd[direction] = box[direction] == 0;
            atEnd[3 + direction] = box[3 + direction] == last[direction];
            if (isAlongBody(direction) && !(atEnd[direction] && atEnd[3 + direction])) {
                findScanEnds(direction, box[3 + direction] - box[direction]);
            }
        }
    }

    /** Finds whether the scan ends in the first or the last layer along the body that holds structures. */
    private void findScanEnds(int direction, int last) {
        if (Math.max(
                        structuresAt(direction, 0).size(),
                        structuresAt(direction, last).size())
                < CUT_STRUCTURES) {
            return;
        }
        int[] greatest = new int[MAX_SEGMENTS + 1];
        for (int at = 0; at <= last; at++) {
            int[] area = area(direction, at);
            Arrays.setAll(greatest, segment -> Math.max(greatest[segment], area[segment]));
        }
        atEnd[direction] |= isCutAt(area(direction, 0), greatest);
        atEnd[3 + direction] |= isCutAt(area(direction, last), greatest);
    }

    private static String held(int[] counts) {
        List<String> labels = new ArrayList<>();
        for (int label = 1; label < counts.length && labels.size() < MAX_LISTED; label++) {
            if (counts[label] > 0) {
                labels.add(String.valueOf(label));
            }
        }
        return labels.isEmpty()
                ? "background alone"
                : "labels " + String.join(", ", labels) + (labels.size() == MAX_LISTED ? " ..." : "");
    }

    /** Finds truncated structures: those that reach the first or last voxel of the volume. */
    public void findCuts() {
        cuts.clear();
        int[] sizes = {columns, rows, slices};
        for (int direction = 0; direction < 3; direction++) {
            if (atEnd[direction]) {
                addCut(direction, 0, false);
            }
            if (atEnd[3 + direction]) {
                addCut(direction, sizes[direction] - 1, true);
            }
        }
    }

    private void addCut(int direction, int layer, boolean forward) {
        CutPlane plane = CutPlane.ofLayer(toMm, direction, layer, forward);
        for (String name : structuresAt(direction, layer)) {
            cuts.computeIfAbsent(name, none -> new ArrayList<>()).add(plane);
        }
    }

    /** Names of the structures in a layer of voxels across a direction of the grid. */
    private List<String> structuresAt(int direction, int at) {
        int[] area = area(direction, at);
        return IntStream.rangeClosed(1, names.size())
                .filter(segment -> area[segment] > 0)
                .mapToObj(segment -> names.get(segment - 1))
                .toList();
    }

    /** Number of voxels of each segment in a layer. */
    private int[] area(int direction, int at) {
        int[] sizes = {columns, rows, slices};
        int[] strides = {1, columns, columns * rows};
        int one = (direction + 1) % 3;
        int two = (direction + 2) % 3;
        int[] area = new int[MAX_SEGMENTS + 1];
        for (int i = 0; i < sizes[one]; i++) {
            for (int j = 0; j < sizes[two]; j++) {
                area[segmentAt(at * strides[direction] + i * strides[one] + j * strides[two])]++;
            }
        }
        return area;
    }

    private static boolean isCutAt(int[] area, int[] greatest) {
        return IntStream.rangeClosed(1, MAX_SEGMENTS)
                        .filter(segment -> area[segment] > 0 && CUT_SHARE * greatest[segment] <= area[segment])
                        .count()
                >= CUT_STRUCTURES;
    }

    /** Whether a direction of the grid runs along the body, up or down, more than across it. */
    boolean isAlongBody(int direction) {
        return "SI".contains(CutPlane.ofLayer(toMm, direction, 0, true).side());
    }

    /** Segment number of a structure. The segment is created if it does not exist. */
    public int segment(String name) {
        if (!names.contains(name)) {
            if (names.size() == MAX_SEGMENTS) {
                throw new BadInputException("found more than " + MAX_SEGMENTS + " structures, expected fewer");
            }
            names.add(name);
        }
        return names.indexOf(name) + 1;
    }

    /** Segment number of a structure; 0 if there is none. */
    public int find(String name) {
        return names.indexOf(name) + 1;
    }

    /** Names of the structures, ordered by segment number. */
    public List<String> names() {
        return names;
    }

    /** Copies labels from the structure that this one was split from. */
    public void inheritFrom(String name, String from) {
        labels.put(name, labels.get(from));
    }

    /** Sets the labels that a structure was built from. */
    public void setLabels(String name, List<Integer> from) {
        labels.put(name, from);
    }

    /** Ends of the scan at which it truncates a structure. */
    public List<CutPlane> cuts(String name) {
        return cuts.getOrDefault(name, List.of());
    }

    /** Labels that a structure was built from. */
    public List<Integer> labels(String name) {
        return labels.get(name);
    }

    /** Segment number of each voxel, as bytes without a sign. */
    public byte[] voxels() {
        return voxels;
    }

    /** Segment number of a voxel; 0 for none. */
    public int segmentAt(int voxel) {
        return voxels[voxel] & MAX_SEGMENTS;
    }

    /** Steps between voxel indices to the neighbours across the faces of a voxel: two along each grid direction. */
    int[] steps() {
        return new int[] {-1, 1, -columns, columns, -columns * rows, columns * rows};
    }

    /** Whether a voxel has no neighbour at the nth of {@link #steps}: it lies at the border of the box. */
    boolean isAtBorder(int voxel, int step) {
        return switch (step) {
            case 0 -> voxel % columns == 0;
            case 1 -> voxel % columns == columns - 1;
            case 2 -> voxel / columns % rows == 0;
            case 3 -> voxel / columns % rows == rows - 1;
            case 4 -> voxel < columns * rows;
            default -> voxel >= columns * rows * (slices - 1);
        };
    }

    /** The ends of the volume at which a voxel lies, one bit each: first column, row and slice, then last ones. */
    public int ends(int voxel) {
        int[] index = {voxel % columns, voxel / columns % rows, voxel / columns / rows};
        int[] last = {columns - 1, rows - 1, slices - 1};
        int ends = 0;
        for (int direction = 0; direction < 3; direction++) {
            ends |= atEnd[direction] && index[direction] == 0 ? 1 << direction : 0;
            ends |= atEnd[3 + direction] && index[direction] == last[direction] ? 8 << direction : 0;
        }
        return ends;
    }

    /** The ends of the volume up or down the body, as bits of {@link #ends}. */
    public int endsToward(boolean up) {
        int ends = 0;
        for (int direction = 0; direction < 3; direction++) {
            if (isAlongBody(direction)) {
                ends |= (toMm[8 + direction] > 0) == up ? 8 << direction : 1 << direction;
            }
        }
        return ends;
    }

    /** Bounding box of a segment: first column, row and slice, then last column, row and slice. */
    int[] box(int segment) {
        return boxes()[segment];
    }

    /** Bounding boxes by segment number, as {@link #box(int)}; the last slice is -1 for a segment without voxels. */
    int[][] boxes() {
        int[][] boxes = new int[MAX_SEGMENTS + 1][];
        Arrays.setAll(boxes, segment -> new int[] {columns, rows, slices, -1, -1, -1});
        for (int k = 0; k < slices; k++) {
            for (int j = 0; j < rows; j++) {
                int row = columns * (j + rows * k);
                for (int i = 0; i < columns; i++) {
                    byte segment = voxels[row + i];
                    int first = i;
                    while (i + 1 < columns && voxels[row + i + 1] == segment) {
                        i++;
                    }
                    if (segment != 0) {
                        int[] box = boxes[segment & MAX_SEGMENTS];
                        box[0] = Math.min(box[0], first);
                        box[1] = Math.min(box[1], j);
                        box[2] = Math.min(box[2], k);
                        box[3] = Math.max(box[3], i);
                        box[4] = Math.max(box[4], j);
                        box[5] = k;
                    }
                }
            }
        }
        return boxes;
    }

    /** Releases the memory of the voxels. */
    public void releaseVoxels() {
        voxels = new byte[0];
    }

    /** Number of voxels of each segment. */
    public int[] counts() {
        int[] counts = new int[names.size() + 1];
        for (byte voxel : voxels) {
            counts[voxel & MAX_SEGMENTS]++;
        }
        return counts;
    }

    /** One coordinate (x, y or z) of a voxel centre, mm. */
    public double coordinate(int voxel, int row) {
        int i = voxel % columns;
        int j = voxel / columns % rows;
        int k = voxel / columns / rows;
        return toMm[4 * row] * i + toMm[4 * row + 1] * j + toMm[4 * row + 2] * k + toMm[4 * row + 3];
    }

    /** Centre of a voxel, mm. */
    public double[] point(int voxel) {
        return new double[] {coordinate(voxel, 0), coordinate(voxel, 1), coordinate(voxel, 2)};
    }

    /** Gives voxels to a segment; 0 leaves them out. */
    public void write(IntList at, int segment) {
        for (int i = 0; i < at.size(); i++) {
            voxels[at.get(i)] = (byte) segment;
        }
    }

    /** The voxels as a grid that shares their memory. */
    public LabelGrid grid() {
        return LabelGrid.of(columns, rows, slices, voxels, toMm);
    }
}
