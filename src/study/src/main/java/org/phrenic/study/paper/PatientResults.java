package org.phrenic.study.paper;

import java.util.List;

/**
 * Results of the patient study.
 *
 * @param cases at least one
 * @param missingNote missing data and its replacement; empty if complete
 * @param quick whether parameters were left untuned
 */
public record PatientResults(List<PatientCase> cases, String missingNote, boolean quick) {
    public PatientResults {
        cases = List.copyOf(cases);
        if (cases.isEmpty()) {
            throw new IllegalArgumentException("found no patient, expected at least one");
        }
    }

    /** Whether all patients are real. */
    public boolean areRealPatients() {
        return cases.stream().noneMatch(PatientCase::synthetic);
    }
}
