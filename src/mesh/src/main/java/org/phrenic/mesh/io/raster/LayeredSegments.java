package org.phrenic.mesh.io.raster;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.phrenic.file.BadInputException;
import org.phrenic.mesh.voxel.LabelGrid;

/**
 * Overlapping segments of 3D Slicer: several layers of labels, in each of which a segment has a value. A voxel belongs
 * to the segment with the fewest voxels, of equal ones to the later. The label of SegmentN is N + 1.
 *
 * @param frames the layers in the file
 * @param segments all segments, in the order of their numbers
 */
record LayeredSegments(VolumeFrames frames, List<Segment> segments) {
    /** Slicer puts segments that do not overlap into one layer. */
    private static final int MAX_LAYERS = 64;

    private static final int MAX_TOLD = 10;

    /** A segment with its layer, its value there, and the label that it gets. */
    record Segment(int label, int layer, int value, String name) {}

    LayeredSegments {
        segments = List.copyOf(segments);
    }

    Map<Integer, String> names() {
        Map<Integer, String> names = new TreeMap<>();
        segments.forEach(segment -> names.put(segment.label(), segment.name()));
        return names;
    }

    /** Reads all layers and merges them. */
    LabelGrid merged(StoredVolume volume) {
        LabelGrid layers = layers(volume);
        int count = frames.count();
        int voxels = layers.voxelCount() / count;
        int alongVoxel = frames.interleaved() ? count : 1;
        int alongLayer = frames.interleaved() ? 1 : voxels;
        List<Segment> ranked = new ArrayList<>(segments);
        int[][] rank = ranks(layers, ranked, volume.notes());
        short[] labels = new short[voxels];
        long overlaps = 0;
        for (int v = 0; v < voxels; v++) {
            int best = 0;
            for (int layer = 0; layer < count; layer++) {
                int here = rank[layer][layers.label(v * alongVoxel + layer * alongLayer)];
                overlaps += here > 0 && best > 0 ? 1 : 0;
                best = Math.max(best, here);
            }
            labels[v] = (short) (best == 0 ? 0 : ranked.get(best - 1).label());
        }
        if (overlaps > 0) {
            volume.notes()
                    .add("structures overlap (" + overlaps
                            + " times in a voxel): such a voxel belongs to the one with the fewest voxels");
        }
        int[] size = volume.voxels().sizes();
        return LabelGrid.of(size[0], size[1], size[2], labels, volume.affine());
    }

    /** All values as one grid, the layers of a voxel side by side or one layer after the other. */
    private LabelGrid layers(StoredVolume volume) {
        int[] size = volume.voxels().sizes();
        long all = volume.voxels().voxels() * frames.count();
        if (frames.count() > MAX_LAYERS || all > Integer.MAX_VALUE - 8) {
            throw new BadInputException(volume.file() + ": found " + frames.count() + " layers of segments with " + all
                    + " voxels, expected at most " + MAX_LAYERS + " with less than 2^31");
        }
        int[] sizes = {(int) (all / size[1] / size[2]), size[1], size[2]};
        VoxelDecoder stored =
                new VoxelDecoder(sizes, volume.voxels().type(), volume.voxels().order());
        stored.checkMemory(volume.file(), 2);
        return stored.decode(volume.file(), volume.in(), volume.affine(), volume.notes());
    }

    /**
     * Sorts segments by their number of voxels, the one with most first.
     *
     * @param notes receives what belongs to no segment
     * @return place of a segment among the sorted ones, from 1, by layer and value; 0 where there is none
     */
    private int[][] ranks(LabelGrid layers, List<Segment> ranked, List<String> notes) {
        int[][] counts = new int[frames.count()][LabelGrid.MAX_LABEL + 1];
        int voxels = layers.voxelCount();
        int perLayer = voxels / frames.count();
        for (int n = 0; n < voxels; n++) {
            counts[frames.interleaved() ? n % frames.count() : n / perLayer][layers.label(n)]++;
        }
        ranked.sort(Comparator.comparingInt(segment -> -counts[segment.layer()][segment.value()]));
        int[][] ranks = new int[frames.count()][LabelGrid.MAX_LABEL + 1];
        for (int r = 0; r < ranked.size(); r++) {
            ranks[ranked.get(r).layer()][ranked.get(r).value()] = r + 1;
        }
        List<String> left = new ArrayList<>();
        for (int layer = 0; layer < counts.length; layer++) {
            for (int value = 1; value <= LabelGrid.MAX_LABEL; value++) {
                if (counts[layer][value] > 0 && ranks[layer][value] == 0) {
                    left.add(counts[layer][value] + " of value " + value + " in layer " + layer);
                }
            }
        }
        if (!left.isEmpty()) {
            notes.add("voxels that belong to no segment were left out: "
                    + String.join(", ", left.subList(0, Math.min(MAX_TOLD, left.size())))
                    + (left.size() > MAX_TOLD ? " ..." : ""));
        }
        return ranks;
    }
}
