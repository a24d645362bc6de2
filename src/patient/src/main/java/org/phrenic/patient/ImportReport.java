package org.phrenic.patient;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.mesh.voxel.LabelGrid;

/** What was built from a volume, from what and how well, as keys and values. */
public final class ImportReport {
    private ImportReport() {}

    /** @param file the volume as the user named it */
    public static Map<String, Object> of(String file, LabelGrid grid, PatientBody body) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("volume", file);
        values.put("voxels", List.of(grid.columns(), grid.rows(), grid.slices()));
        values.put("spacing_mm", List.of(grid.spacing(0), grid.spacing(1), grid.spacing(2)));
        double voxelMm = Math.cbrt(grid.voxelVolume());
        values.put("voxel_mm", voxelMm);
        List<Map<String, Object>> rows = new ArrayList<>();
        body.structures().forEach(organ -> rows.add(row(organ, voxelMm)));
        values.put("structures", rows);
        values.put("missing", body.missing());
        values.put("can_breathe", body.canBreathe());
        values.put("notes", body.notes());
        return values;
    }

    private static Map<String, Object> row(PatientStructure organ, double voxelMm) {
        Map<String, Object> row = new LinkedHashMap<>();
        row.put("structure", organ.structure().name());
        row.put("source", organ.source().name().toLowerCase(Locale.ROOT));
        row.put("mesh_volume_ml", MeshMeasure.signedVolume(organ.structure().mesh()) / 1000);
        organ.scan().ifPresent(scan -> {
            row.put("labels", scan.labels());
            row.put("voxels", scan.voxels());
            row.put("label_volume_ml", scan.volumeMl());
            row.put("cut_at", scan.cutAt());
            row.put("label_surface_vertices", scan.meshed().labelVertices());
            row.put("decimated_vertices", scan.meshed().decimatedVertices());
            row.put("last_pass_band", scan.meshed().secondPassBand());
            DistanceSummary off = scan.meshed().distanceToLabel();
            row.put("off_label_mean_mm", off.mean());
            row.put("off_label_mean_voxels", off.mean() / voxelMm);
            row.put("off_label_percentile_95_mm", off.percentile95());
            row.put("off_label_maximum_mm", off.maximum());
        });
        organ.distanceToScan().ifPresent(off -> {
            row.put("fit_off_scan_mean_mm", off.mean());
            row.put("fit_off_scan_percentile_95_mm", off.percentile95());
        });
        MeshQuality quality = MeshQuality.of(organ.structure().mesh());
        row.put("vertices", quality.vertices());
        row.put("triangles", quality.triangles());
        row.put("smallest_angle_deg", quality.smallestAngleDeg());
        row.put("mean_edge_mm", quality.meanEdgeMm());
        row.put("edge_ratio", Double.isFinite(quality.edgeRatio()) ? quality.edgeRatio() : null);
        return row;
    }
}
