package org.phrenic.study.sweep;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.phrenic.file.BadInputException;
import org.phrenic.study.body.BodyVariation;

/** Persons of a cohort follow the table, and their bodies follow their persons. */
class CohortTest {
    private static final Cohort ADULTS = Cohort.shipped();
    private static final String RESPONSE = "responses:\n  - {observable: liver_si_mm, reduction: size}\n";

    private static double mean(List<Person> persons, String sex, ToDoubleFunction<Person> of) {
        return persons.stream()
                .filter(p -> p.sex().equals(sex))
                .mapToDouble(of)
                .average()
                .orElseThrow();
    }

    /** Means of NHANES 2015 to 2018: 1.753 m and 90.6 kg, 1.613 m and 77.5 kg. */
    @Test
    void thousandPersonsHaveTheMeansOfTheirSource() {
        List<Person> persons = ADULTS.draw(4000, 1);
        assertThat(mean(persons, "male", Person::heightM)).isCloseTo(1.753, within(0.005));
        assertThat(mean(persons, "female", Person::heightM)).isCloseTo(1.613, within(0.005));
        assertThat(mean(persons, "male", Person::weightKg)).isCloseTo(90.6, within(2.0));
        assertThat(mean(persons, "female", Person::weightKg)).isCloseTo(77.5, within(2.0));
        assertThat(mean(persons, "male", Person::ageYears)).isCloseTo(49.5, within(1.5));
        assertThat(ADULTS.draw(10, 1)).isEqualTo(persons.subList(0, 10));
        assertThat(ADULTS.draw(10, 2)).isNotEqualTo(persons.subList(0, 10));
        assertThat(persons).allMatch(p -> Person.parse(p.text()).equals(p));
    }

    @Test
    void theBodyOfAPersonHasHisStatureAndGirth() {
        assertThat(ADULTS.variation(Person.parse("male 35 y 1.75 m 75 kg")))
                .isEqualTo(new BodyVariation(1, 1, 1, 0, 0, 0));
        BodyVariation heavy = ADULTS.variation(Person.parse("male 35 y 1.75 m 120 kg"));
        assertThat(heavy.scaleX()).isCloseTo(BodyVariation.HEAVY.scaleX(), within(0.01));
        assertThat(heavy.scaleY()).isCloseTo(BodyVariation.HEAVY.scaleY(), within(0.01));
        assertThat(heavy.scaleZ()).isEqualTo(1);
        assertThat(heavy.barrel()).isCloseTo(BodyVariation.HEAVY.barrel(), within(0.005));
        assertThat(heavy.domeLiftMm()).isCloseTo(BodyVariation.HEAVY.domeLiftMm(), within(1.0));
        BodyVariation old = ADULTS.variation(Person.parse("female 75 y 1.55 m 50 kg"));
        assertThat(old.kyphosisDeg()).isCloseTo(12, within(1e-9));
        assertThat(old.scaleZ()).isCloseTo(1.55 / 1.65, within(1e-12));
        assertThat(old.scaleX()).isLessThan(old.scaleZ());
        assertThat(ADULTS.body(Person.parse("female 75 y 1.55 m 50 kg"))).isEqualTo("virtual/adult-female");
    }

    @Test
    void aCohortIsAFactorWhoseTraitsAreColumns() {
        SweepPlan plan = SweepPlan.of(SweepStudy.parse(
                "study.yaml",
                "cohort: {persons: 5, seed: 3}\nfactors:\n  - {key: depth, values: [1, 1.2]}\n"
                        + "design: {kind: grid}\n" + RESPONSE));
        assertThat(plan.size()).isEqualTo(10);
        Person third = ADULTS.draw(5, 3).get(2);
        SweepPoint point = plan.points().get(2);
        assertThat(point.values()).containsExactly("1", third.text());
        assertThat(plan.model().traitNames()).containsExactly("sex", "age_y", "height_m", "weight_kg");
        assertThat(plan.model().traits(point)).startsWith(third.sex());
        assertThat(SweepStudy.parse("again", plan.study().resolved()).factors()).hasSize(2);
    }

    @Test
    void personsAndAnotherFactorOfTheBodyAreRefused() {
        assertThatThrownBy(() -> SweepStudy.parse(
                        "study.yaml",
                        "cohort: {persons: 2}\nfactors:\n  - {key: body.scale, values: [1]}\n"
                                + "design: {kind: grid}\n" + RESPONSE))
                .isInstanceOf(BadInputException.class)
                .hasMessage("study.yaml: found persons and another factor of the body, expected one of them");
        for (String absurd : new String[] {"9.99 m 75 kg", "0.5 m 75 kg", "1.75 m 5 kg", "1.75 m 999 kg"}) {
            assertThatThrownBy(() -> Person.parse("male 35 y " + absurd)).hasMessageContaining("1.2 to 2.3 m");
        }
        assertThatThrownBy(() -> Person.parse("man 35")).hasMessageContaining("expected sex, age, height and weight");
    }
}
