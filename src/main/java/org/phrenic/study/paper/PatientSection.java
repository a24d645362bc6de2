package org.phrenic.study.paper;

import java.util.List;
import org.phrenic.format.ReportDocument;
import org.phrenic.format.ReportDocument.Column;
import org.phrenic.study.paper.Claim.Verdict;

/** The paper's patients: its figures are stated, ours are not there yet. */
final class PatientSection {
    private static final String LATER = "not there yet";

    private PatientSection() {}

    static void add(ReportDocument report) {
        report.section("Figs. 4 and 5, table 2: the patients");
        report.remark(
                "Not there yet: no patient is reproduced in this report. Its own scans are not public; a public scan"
                        + " at two breath levels will stand in their place.");
        report.table(
                "Fig. 5: distance between the lungs' surface in the simulation and in the scan at the end of inhale, mean and"
                        + " standard deviation in mm (MeshDev).",
                List.of(
                        Column.text("subject"),
                        Column.text("data"),
                        Column.number("no model"),
                        Column.number("with the model"),
                        Column.text("here")),
                List.of(
                        List.of("1", "4D CT", "-", "moved too little to tell", LATER),
                        List.of("2", "4D CT", "5.8 ± 5", "4.29 ± 3.6", LATER),
                        List.of("3", "MRI, volunteer, two breath holds", "16 ± 9.4", "12 ± 6.7", LATER)));
        report.points(
                "Fig. 4, a segmented diaphragm and its mesh (6,633 nodes, 13,267 triangles): " + LATER
                        + ". An odd number of triangles is no closed surface: there is a border, or a misprint.",
                "Pipeline (segmentation by hand, mesh, windowed-sinc smoothing with a pass band of 0.2, 50 % decimation, 200"
                        + " more iterations; no rib motion; small forces on the action lines; lungs linked by springs): "
                        + LATER + ".",
                "Table 2, iterations a second of subject 1: " + LATER
                        + ". As printed it repeats table 1 in every figure,"
                        + " vertices included, although the patient's mesh is another: the patient's speed is unknown.");
    }

    static List<Claim> claims() {
        return List.of(
                new Claim("Fig. 4: patient's diaphragm, segmented and meshed", "", "", Verdict.NOT_THERE_YET, ""),
                new Claim("Fig. 5: distance to the scan, three subjects", "", "", Verdict.NOT_THERE_YET, ""),
                new Claim("Table 2: iterations a second, subject 1", "", "", Verdict.NOT_THERE_YET, ""));
    }
}
