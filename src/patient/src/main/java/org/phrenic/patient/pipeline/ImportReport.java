package org.phrenic.patient.pipeline;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.phrenic.document.OrderedValues;
import org.phrenic.engine.kinematics.RigidMotion;
import org.phrenic.mesh.MeshMeasure;
import org.phrenic.mesh.MeshQuality;
import org.phrenic.mesh.query.DistanceSummary;
import org.phrenic.patient.PatientBody;
import org.phrenic.patient.PatientStructure;
import org.phrenic.patient.diaphragm.SheetQuality;
import org.phrenic.patient.registration.ScanAlignment;

/** The report of an import: the structures built from a volume, and their accuracy. */
final class ImportReport {
    private ImportReport() {}

    static OrderedValues of(ImportResult result) {
        PatientBody body = result.body();
        double voxelMm =
                result.grid().map(grid -> StrictMath.cbrt(grid.voxelVolume())).orElse(Double.NaN);
        OrderedValues report = new OrderedValues();
        if (result.grid().isEmpty()) {
            report.with("folder", result.file());
        }
        result.grid().ifPresent(grid -> report.with("volume", result.file())
                .with("voxels", List.of(grid.columns(), grid.rows(), grid.slices()))
                .with("spacing_mm", List.of(grid.spacing(0), grid.spacing(1), grid.spacing(2)))
                .with("voxel_mm", voxelMm));
        report.with(
                        "structures",
                        body.structures().stream().map(s -> row(s, voxelMm)).toList())
                .with("missing", body.missing())
                .with("can_breathe", body.canBreathe());
        result.resting().flatMap(RestingBody::report).ifPresent(level -> report.with("breath_level", level));
        result.quality().ifPresent(quality -> report.with("diaphragm_quality", quality(quality)));
        result.alignment().ifPresent(a -> report.with("alignment", alignment(a)));
        return report.with("notes", body.notes());
    }

    private static OrderedValues alignment(ScanAlignment a) {
        RigidMotion m = a.motion();
        return new OrderedValues()
                .with("fixed_part", a.fixedPart().label())
                .with("turn_deg", a.rotationDeg())
                .with(
                        "rotation",
                        IntStream.range(0, 9)
                                .mapToObj(i -> m.rotation(i / 3, i % 3))
                                .toList())
                .with("translation_mm", List.of(m.translation(0), m.translation(1), m.translation(2)))
                .with("residual_rms_mm", a.residual().rms())
                .with("inlier_residual_rms_mm", a.inlierResidual().rms());
    }

    private static OrderedValues quality(SheetQuality quality) {
        OrderedValues rows = new OrderedValues();
        for (SheetQuality.Measure m : quality.measures()) {
            rows.with(
                    m.key(),
                    new OrderedValues()
                            .with("value", Double.isFinite(m.value()) ? m.value() : null)
                            .with("limit", m.limit())
                            .with("good", m.isGood()));
        }
        return rows;
    }

    private static OrderedValues row(PatientStructure s, double voxelMm) {
        OrderedValues row = new OrderedValues()
                .with("structure", s.structure().name())
                .with("source", s.source().name().toLowerCase(Locale.ROOT))
                .with("mesh_volume_ml", MeshMeasure.signedVolumeMl(s.structure().mesh()));
        s.scan().ifPresent(scan -> {
            DistanceSummary off = scan.meshed().distanceToLabel();
            row.with("labels", scan.labels())
                    .with("voxels", scan.voxels())
                    .with("label_volume_ml", scan.volumeMl())
                    .with("cut_at", scan.cutAt())
                    .with("label_surface_vertices", scan.meshed().labelVertices())
                    .with("decimated_vertices", scan.meshed().decimatedVertices())
                    .with("last_pass_band", scan.meshed().secondPassBand())
                    .with("off_label_mean_mm", off.mean())
                    .with("off_label_mean_voxels", off.mean() / voxelMm)
                    .with("off_label_percentile_95_mm", off.percentile95())
                    .with("off_label_maximum_mm", off.maximum());
        });
        s.distanceToScan().filter(off -> off.points() > 0).ifPresent(off -> row.with("fit_off_scan_mean_mm", off.mean())
                .with("fit_off_scan_percentile_95_mm", off.percentile95()));
        MeshQuality quality = MeshQuality.of(s.structure().mesh());
        return row.with("vertices", quality.vertices())
                .with("triangles", quality.triangles())
                .with("smallest_angle_deg", quality.smallestAngleDeg())
                .with("mean_edge_mm", quality.meanEdgeMm())
                .with("edge_ratio", Double.isFinite(quality.edgeRatio()) ? quality.edgeRatio() : null);
    }
}
