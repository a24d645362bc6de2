package org.phrenic.study.body;

import static org.phrenic.file.Numbers.format;
import static org.phrenic.file.Numbers.trimmed;
import static org.phrenic.study.ReportNumbers.number;

import java.util.ArrayList;
import java.util.List;
import org.phrenic.document.OrderedValues;
import org.phrenic.document.report.Disclaimer;
import org.phrenic.document.report.ReportDocument;
import org.phrenic.document.report.ReportDocument.Column;
import org.phrenic.scenario.Scenario;
import org.phrenic.study.ReportNumbers;

/** Volumes and overlaps of organs, as values for JSON and as a page. */
public final class OrganReport {
    /** Greatest deviation of a volume from its reference. */
    private static final double VOLUME_SHARE = 0.30;
    /** Pairs with less of both are left out of the list of pairs. */
    private static final double LISTED_PERCENT = 0.1;

    private static final double LISTED_MM = 1;

    private final Scenario scenario;
    private final List<OrganMoment> moments;

    OrganReport(Scenario scenario, List<OrganMoment> moments) {
        this.scenario = scenario;
        this.moments = List.copyOf(moments);
    }

    /** Whether all volumes and all pairs are within the limits. */
    public boolean passes() {
        return moments.stream().allMatch(OrganMoment::isWithin) && volumesBeyond() == 0;
    }

    /** What was found, in one sentence without a full stop. */
    public String summary() {
        return format(
                "%d of %d volumes differ from the reference by more than %.0f %%; %d of %d pairs overlap by more than"
                        + " %s %% of the smaller or %s mm",
                volumesBeyond(),
                volumes().size(),
                100 * VOLUME_SHARE,
                moments.stream()
                        .flatMap(m -> m.contacts().stream())
                        .filter(c -> !c.isWithin())
                        .count(),
                moments.stream().mapToInt(m -> m.contacts().size()).sum(),
                trimmed(OrganContact.MOST_PERCENT, 2),
                trimmed(BodyLimits.THROUGH_MM, 2));
    }

    /** An organ at rest beside its reference. */
    private record Volume(String body, OrganVolume organ, double ml, double deepMl) {
        double referenceMl() {
            return organ.referenceMl(body.contains("female"));
        }

        /** Relative deviation from the reference. */
        double deviation() {
            return ml / referenceMl() - 1;
        }

        boolean isWithin() {
            return Math.abs(deviation()) <= VOLUME_SHARE;
        }
    }

    private List<Volume> volumes() {
        List<Volume> all = new ArrayList<>();
        for (OrganMoment rest : moments) {
            if (rest.name().equals(OrganMoment.REST)) {
                OrganMoment deep = moments.stream()
                        .filter(m -> m.body().equals(rest.body()) && m.name().equals(BreathDepth.DEEP.preset()))
                        .findFirst()
                        .orElseThrow();
                for (OrganVolume organ : OrganVolume.ALL) {
                    if (!rest.volumesMl().containsKey(organ.name())) {
                        continue;
                    }
                    all.add(new Volume(
                            rest.body(),
                            organ,
                            rest.volumesMl().get(organ.name()),
                            deep.volumesMl().get(organ.name())));
                }
            }
        }
        return all;
    }

    private long volumesBeyond() {
        return volumes().stream().filter(v -> !v.isWithin()).count();
    }

    /** One line for each moment: the largest overlap and the greatest depth. */
    public List<List<String>> table() {
        return moments.stream()
                .map(moment -> {
                    OrganContact overlap = moment.most(OrganContact::overlapPercent);
                    OrganContact deepest = moment.most(OrganContact::depthMm);
                    return List.of(
                            moment.body(),
                            moment.name(),
                            String.valueOf(moment.contacts().size()),
                            number(overlap.overlapPercent()),
                            overlap.overlapPercent() > 0 ? overlap.pair() : "",
                            number(deepest.depthMm()),
                            deepest.depthMm() > 0 ? deepest.pair() : "",
                            moment.isWithin() ? "yes" : "no");
                })
                .toList();
    }

    /** @param provenance how it was made: commit, command, machine, date */
    public ReportDocument document(List<String> provenance) {
        ReportDocument report = new ReportDocument("Organs of the virtual bodies", summary() + ".");
        report.points(provenance.toArray(String[]::new));
        report.paragraph("Each body at rest and at the full inspirations (lowest domes of 60 moments) of a quiet and of"
                + " a deep breath from rest, default numbers, "
                + ReportNumbers.label(scenario.resolution()) + " resolution. Pairs: organs, liver, lungs and large"
                + " vessels, but not two vessels, nor a vessel and the liver. Overlap: common volume on a grid of 2 mm"
                + " in per cent of the smaller. Depth: greatest distance of a vertex of either inside the other from"
                + " the surface of that.");
        report.table(
                "",
                Column.list("body | moment | # pairs | # largest overlap % | of | # greatest depth mm | of | within"),
                table());
        addVolumes(report);
        addPairs(report);
        return report;
    }

    private void addVolumes(ReportDocument report) {
        report.section("Volumes");
        report.paragraph("References: masses with contents of ICRP Publication 89 (adult man; woman) over densities of"
                + " 1.03 to 1.06 g/ml; of the duodenum 25 of 280 cm of the small intestine, of the colon 66 of 96 cm"
                + " of the large intestine. Deep: at the full inspiration of the deep breath.");
        report.table(
                "",
                Column.list("body | organ | # reference ml | # at rest ml | # difference % | # deep ml | within"),
                volumes().stream()
                        .map(v -> List.of(
                                v.body(),
                                v.organ().name(),
                                format("%.0f", v.referenceMl()),
                                format("%.0f", v.ml()),
                                format("%+.0f", 100 * v.deviation()),
                                format("%.0f", v.deepMl()),
                                v.isWithin() ? "yes" : "no"))
                        .toList());
    }

    private void addPairs(ReportDocument report) {
        report.section("Pairs");
        report.paragraph(format(
                "Pairs with an overlap above %s %% or a depth above %s mm.",
                trimmed(LISTED_PERCENT, 2), trimmed(LISTED_MM, 2)));
        List<List<String>> rows = new ArrayList<>();
        for (OrganMoment moment : moments) {
            for (OrganContact c : moment.contacts()) {
                if (c.overlapPercent() > LISTED_PERCENT || c.depthMm() > LISTED_MM) {
                    rows.add(List.of(
                            moment.body(),
                            moment.name(),
                            c.pair(),
                            number(c.overlapPercent()),
                            number(c.depthMm()),
                            c.isWithin() ? "yes" : "no"));
                }
            }
        }
        report.table("", Column.list("body | moment | pair | # overlap % | # depth mm | within"), rows);
    }

    /** The values for JSON. */
    public OrderedValues values() {
        return new OrderedValues()
                .with("notice", Disclaimer.TEXT)
                .with("passes", passes())
                .with("resolution", ReportNumbers.label(scenario.resolution()))
                .with("moments", moments.stream().map(OrganMoment::values).toList());
    }
}
