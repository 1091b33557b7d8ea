"""What is right: features, rules, actions with their preconditions, verdicts on moves."""
