package org.phrenic.study.paper;

import java.util.List;

/**
 * What was found of patients.
 *
 * @param cases at least one
 * @param missingNote what is not there, and what stands in its place; empty if nothing
 * @param quick whether nothing was tuned
 */
public record PatientResults(List<PatientCase> cases, String missingNote, boolean quick) {
    public PatientResults {
        cases = List.copyOf(cases);
        if (cases.isEmpty()) {
            throw new IllegalArgumentException("found no patient, expected at least one");
        }
    }

    /** Whether real patients lie behind it. */
    public boolean areRealPatients() {
        return cases.stream().noneMatch(PatientCase::synthetic);
    }
}
