package org.phrenic.cli.report;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.phrenic.mesh.io.volume.LabelVolume;
import org.phrenic.mesh.io.volume.LabelVolumeFiles;
import org.phrenic.mesh.voxel.LabelGrid;

/** What a volume of labels holds: its size in voxels and mm, and the volume of each label, in ml. */
public final class VolumeInfo {
    private static final double MM3_PER_ML = 1000;

    private VolumeInfo() {}

    public static Map<String, Object> of(Path file) {
        LabelVolume volume = LabelVolumeFiles.read(file);
        LabelGrid grid = volume.grid();
        double[] first = new double[3];
        double[] last = new double[3];
        grid.voxelToMm(0, 0, 0, first);
        grid.voxelToMm(grid.columns() - 1, grid.rows() - 1, grid.slices() - 1, last);
        Map<String, Object> info = new LinkedHashMap<>();
        info.put("file", file.toString());
        info.put("kind", "label volume");
        info.put("voxels", List.of(grid.columns(), grid.rows(), grid.slices()));
        info.put("spacing_mm", List.of(grid.spacing(0), grid.spacing(1), grid.spacing(2)));
        info.put("first_voxel_lps_mm", list(first));
        info.put("last_voxel_lps_mm", list(last));
        Map<String, Object> labels = new LinkedHashMap<>();
        int[] counts = grid.counts();
        for (int label = 1; label < counts.length; label++) {
            if (counts[label] > 0) {
                String name = volume.names().getOrDefault(label, "");
                labels.put((label + " " + name).strip(), counts[label] * grid.voxelVolume() / MM3_PER_ML);
            }
        }
        info.put("labels_ml", labels);
        info.put("notes", volume.notes());
        return info;
    }

    private static List<Double> list(double[] place) {
        return List.of(place[0], place[1], place[2]);
    }
}
