"""The few-shot learner: one to three natural demonstrations, questions, and honest doubt."""
